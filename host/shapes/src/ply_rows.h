// Elements of binary PLY files whose rows all take the same bytes: each value's place is known.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "ply_values.h"

namespace lxs {

class PlyRows {
  public:
    /// `first`: where row 0 begins. A list has `list_length` values.
    PlyRows(const PlyElement& element, const char* first, PlyFormat format,
            std::size_t list_length);
    std::size_t bytes() const { return count_ * row_bytes_; }
    /// Of a list, its length as the row has it.
    double value(std::size_t row, std::size_t column) const {
        const Column& c = columns_[column];
        return binary_value(first_ + row * row_bytes_ + c.offset, c.type, format_);
    }
    double list_value(std::size_t row, std::size_t column, std::size_t k) const {
        const Column& c = columns_[column];
        const std::size_t at = c.offset + size_of(c.type) + k * size_of(c.item_type);
        return binary_value(first_ + row * row_bytes_ + at, c.item_type, format_);
    }

  private:
    struct Column {
        std::size_t offset;
        PlyType type;       ///< of the value, or of the list's length
        PlyType item_type;  ///< of a list
    };
    const char* first_;
    PlyFormat format_;
    std::size_t count_, row_bytes_ = 0;
    std::vector<Column> columns_;
};

/// The rows of `element`, which begins at what `values` reads next, if they could be of one length:
/// in a binary file that is long enough, without lists but, for a `list_length` above 0, a single
/// one. Whether that list is as long in each row is the caller's to see.
std::optional<PlyRows> equal_rows(const PlyElement& element, const PlyValues& values,
                                  std::size_t list_length);

}  // namespace lxs
