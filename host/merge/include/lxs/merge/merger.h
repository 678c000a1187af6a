// Joins renders of one scene that differ in their seeds.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "lxs/imaging/error_estimate.h"
#include "lxs/imaging/exr_image.h"
#include "lxs/merge/matte_sums.h"

namespace lxs {

/// Renders that do not belong together; says which and why.
class MergeRefusal : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// One mean of images, each weighing as many samples per pixel as it holds. Their seeds must
/// differ, all else that an image depends on must not: then they are independent estimates of the
/// same expectation.
///
/// The layer `error` (standard deviations) is that of the mean: its squares add by the squares of
/// the weights. Of `depth` the least is kept, and cryptomattes are joined id by id. All other
/// channels are means.
class Merger {
  public:
    /// `name` stands for the image in messages. Throws MergeRefusal, and then holds what it held.
    void add(const ExrImage& image, const std::string& name);

    /// After at least one add(). Its header does not tell the error, which takes time of its own.
    ExrImage merged() const;
    /// Of merged(), if all its images know theirs.
    std::optional<ErrorEstimate> error() const;

    double samples_per_pixel() const { return weight_; }
    std::uint64_t passes() const { return passes_; }
    std::vector<std::uint64_t> seeds() const;
    std::size_t images() const { return images_; }

  private:
    struct Told;  // by an image's header
    void check(const ExrImage& image, const Told& told, const std::string& name) const;
    void add_channel(const std::string& channel, const std::vector<float>& values, double weight);
    void check_seeds(const Told& told, const std::string& name) const;
    void check_layers(const ExrImage& image, const std::string& name) const;

    FilmFrame frame_;
    /// By channel: sums; of errors, of squares; of depths the least so far; of cryptomattes
    /// nothing.
    std::map<std::string, std::vector<double>> sums_;
    std::map<std::string, MatteSums> mattes_;     ///< by name
    ImageMetadata common_;                        ///< what all headers say alike
    std::string first_;                           ///< name of the first image
    std::map<std::uint64_t, std::string> seeds_;  ///< and the image that has it
    double weight_ = 0, freedom_ = 0;
    double relmse_of_bias_ = 0, mse_of_bias_ = 0;  ///< sums, weighted by samples
    std::uint64_t passes_ = 0;
    std::size_t images_ = 0;
};

}  // namespace lxs
