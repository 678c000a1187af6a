// Can a scene's references be trusted? Agreement of the two, and the bias that their radius leaves.
#pragma once

#include <array>
#include <vector>

#include "block_test.h"
#include "reference_store.h"

namespace bench {

/// Blocks per side of the grid on which references are compared.
inline constexpr int kBlocksPerSide = 8;
/// Family-wise probability of calling two equal references different.
inline constexpr double kDisagreement = 1e-4;

/// Mean luminance of kBlocksPerSide x kBlocksPerSide blocks, row by row. Images of fewer pixels
/// than blocks repeat pixels.
std::vector<double> block_luminances(const Image& image);

/// Block luminances of a reference's "chunks", as reference.json has them.
statistics::BlockMeans chunk_blocks(const Json& chunks);

/// "agreement" of docs/reference/benchmark-files.md from the chunks of images 1 and 2; null with
/// fewer than three chunks in either.
Json agreement(const Json& images);

/// "bias_left" of docs/reference/benchmark-files.md. `halved` carries its own standard error.
Json bias_left(const ReferencePair& references, const WeightedImage& halved);

/// Root of the mean squared standard error over the mean luminance; null with one chunk.
Json relative_standard_error(const WeightedImage& image);

}  // namespace bench
