// What archives check by themselves.
#include "aips/core/base/state_archive.h"

#include <cmath>
#include <string>

namespace aips {
namespace {

constexpr const char* kNoAmount = "a sum that is negative or not finite";

bool is_amount(double value) {
    return value >= 0 && std::isfinite(value);
}

}  // namespace

void StateArchive::value(bool& value) {
    std::uint8_t byte = value ? 1 : 0;
    this->value(byte);
    check(byte <= 1, "a switch that is neither on nor off");
    value = byte == 1;
}

void StateArchive::amount(float& value) {
    this->value(value);
    check(!restoring() || is_amount(double(value)), kNoAmount);
}

void StateArchive::amount(double& value) {
    this->value(value);
    check(!restoring() || is_amount(value), kNoAmount);
}

std::size_t StateArchive::count(std::size_t size, std::size_t element_bytes) {
    auto saved = static_cast<std::uint64_t>(size);
    value(saved);
    if (restoring())
        check(saved <= remaining() / element_bytes, "more elements than there is data");
    return static_cast<std::size_t>(saved);
}

void StateArchive::fixed_count(std::size_t size) {
    auto saved = static_cast<std::uint64_t>(size);
    value(saved);
    check(saved == size, "another number of elements than this render has");
}

void StateArchive::refuse(const char* complaint) {
    throw StateError(std::string("the engine's saved state is damaged: ") + complaint);
}

void StateArchive::refuse_other(const char* what) {
    throw StateError(std::string("the engine's saved state is of another render: other ") + what);
}

}  // namespace aips
