// The response of a camera or film to light: what LuxRender's "cameraresponse" applies.
// Source of the file format and the measured curves: Grossberg and Nayar 2004, "Modeling the space
// of camera response functions" (database of response functions).
#pragma once

#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "lxs/sdk/diagnostics.h"

namespace lxs {

/// Brightness by irradiance, both of the range 0 to 1, for one channel: straight between points.
struct ResponseCurve {
    std::vector<double> irradiance;  ///< never falling, not empty
    std::vector<double> brightness;  ///< as many

    double at(double value) const;
};

/// Curves of red, green and blue, or one that makes all grey.
class CameraResponse {
  public:
    /// One curve: black and white film; three: red, green, blue. As in LuxRender, the gamma that
    /// fits the curves best, which a display undoes, is taken out of them.
    explicit CameraResponse(std::vector<ResponseCurve> curves);

    /// Linear RGB before a display's gamma, from tone-mapped linear RGB.
    std::array<double, 3> map(const std::array<double, 3>& rgb) const;
    double gamma() const { return gamma_; }  ///< that has been taken out

  private:
    std::vector<ResponseCurve> curves_;
    double gamma_ = 1;
};

/// What is wrong with a file of curves, and where in it.
class ResponseFileError : public std::runtime_error {
  public:
    ResponseFileError(SourceLocation where, const std::string& message)
        : std::runtime_error(message), where_(std::move(where)) {}
    const SourceLocation& where() const { return where_; }

  private:
    SourceLocation where_;
};

/// Reads curves as the database's files give them: for each, a name that ends in Red, Green or Blue
/// (else it is a black and white film's), a line "graph ...", "I =" and a line of irradiances,
/// "B =" and a line of as many brightnesses. Throws ResponseFileError.
CameraResponse read_camera_response(const std::shared_ptr<const SourceFile>& file);

/// True for the names of the curves that LuxRender has built in.
bool is_builtin_response(std::string_view name);

}  // namespace lxs
