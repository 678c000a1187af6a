// The file format of checkpoints and of what was learned.
#include "lxs/host/checkpoint_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <system_error>

namespace lxs {
namespace {

using Mark = std::array<char, 8>;

constexpr std::uint32_t kByteOrder = 0x01020304;

/// First and last bytes of a file.
struct Head {
    Mark mark{};
    std::uint32_t version = 0;
    std::uint32_t byte_order = kByteOrder;
};
struct Tail {
    std::uint64_t checksum = 0;
    Mark mark{'L', 'X', 'S', 'W', 'H', 'O', 'L', 'E'};
};
static_assert(std::has_unique_object_representations_v<Head> &&
              std::has_unique_object_representations_v<Tail>);

constexpr std::size_t kBufferBytes = std::size_t{1} << 20;

template <class T>
std::span<const std::byte> bytes_of(const T& value) {
    return std::as_bytes(std::span(&value, 1));
}

template <class T>
T read_as(std::span<const std::byte> bytes) {
    T value;
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
}

void check_head(std::span<const std::byte> file, const SealedFormat& format) {
    if (file.size() < sizeof(Head) || read_as<Head>(file).mark != format.mark)
        throw StateError(fmt::format("it is no {}", format.name));
    const Head head = read_as<Head>(file);
    if (head.byte_order != kByteOrder)
        throw StateError("it was written on a machine with another order of bytes");
    if (head.version != format.version) {
        throw StateError(
            fmt::format("it was written in version {} of the format, but this "
                        "lxsrender reads version {}",
                        head.version, format.version));
    }
}

[[noreturn]] void fail_reading(int error) {
    throw StateError("it can't be read: " + std::generic_category().message(error));
}

class InputFile {
  public:
    explicit InputFile(const std::string& path)
        : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
        if (descriptor_ < 0) fail_reading(errno);
    }
    ~InputFile() { ::close(descriptor_); }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    std::size_t size() const {
        struct stat status {};
        if (::fstat(descriptor_, &status) != 0) fail_reading(errno);
        if (!S_ISREG(status.st_mode)) throw StateError("it is no regular file");
        return static_cast<std::size_t>(status.st_size);
    }

    void read(std::span<std::byte> bytes) {
        while (!bytes.empty()) {
            const ssize_t got = ::read(descriptor_, bytes.data(), bytes.size());
            if (got < 0 && errno == EINTR) continue;
            if (got < 0) fail_reading(errno);
            if (got == 0) throw StateError("it became shorter while it was read");
            bytes = bytes.subspan(static_cast<std::size_t>(got));
        }
    }

  private:
    int descriptor_;
};

}  // namespace

CheckpointWriter::CheckpointWriter(const std::string& path, const SealedFormat& format)
    : file_(path) {
    buffer_.reserve(kBufferBytes);
    append(bytes_of(Head{.mark = format.mark, .version = format.version}));
}

void CheckpointWriter::bytes(std::span<std::byte> data) {
    append(data);
}

void CheckpointWriter::append(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const std::size_t part = std::min(bytes.size(), kBufferBytes - buffer_.size());
        buffer_.insert(buffer_.end(), bytes.begin(),
                       bytes.begin() + static_cast<std::ptrdiff_t>(part));
        bytes = bytes.subspan(part);
        if (buffer_.size() == kBufferBytes) flush();
    }
}

void CheckpointWriter::flush() {
    checksum_.add(buffer_);
    file_.write(buffer_);
    buffer_.clear();
}

void CheckpointWriter::commit() {
    flush();
    Tail tail;
    tail.checksum = checksum_.value();
    file_.write(bytes_of(tail));
    file_.commit();
}

void CheckpointReader::bytes(std::span<std::byte> data) {
    if (data.size() > left_.size()) throw StateError("its content ends too soon");
    std::copy_n(left_.begin(), data.size(), data.begin());
    left_ = left_.subspan(data.size());
}

std::span<const std::byte> checkpoint_content(std::span<const std::byte> file,
                                              const SealedFormat& format) {
    check_head(file, format);
    if (file.size() < sizeof(Head) + sizeof(Tail)) throw StateError("it is cut off");
    const auto tail = read_as<Tail>(file.last(sizeof(Tail)));
    if (tail.mark != Tail{}.mark) throw StateError("it is cut off, or its end is damaged");
    Checksum checksum;
    checksum.add(file.first(file.size() - sizeof(Tail)));
    if (checksum.value() != tail.checksum)
        throw StateError("it is damaged: its checksum is not that of its content");
    return file.subspan(sizeof(Head), file.size() - sizeof(Head) - sizeof(Tail));
}

std::vector<std::byte> read_checkpoint_file(const std::string& path, const SealedFormat& format) {
    InputFile input(path);
    const std::size_t size = input.size();
    std::array<std::byte, sizeof(Head)> head{};
    const std::span<std::byte> begin = std::span(head).first(std::min(size, sizeof(Head)));
    input.read(begin);
    check_head(begin, format);
    std::vector<std::byte> file(size);
    std::copy(head.begin(), head.end(), file.begin());
    input.read(std::span(file).subspan(sizeof(Head)));
    return file;
}

}  // namespace lxs
