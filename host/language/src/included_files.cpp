// Reading of files, include cycles and depth.
#include "included_files.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <system_error>

#include "grammar.h"
#include "lxs/scene/registry.h"

namespace lxs {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxIncludeDepth = 32;
constexpr std::size_t kMaxSize = std::numeric_limits<std::uint32_t>::max();  // columns fit
// Files that include others twice grow without end before they nest too deep.
constexpr std::size_t kMaxIncludes = 100'000;
constexpr std::size_t kMaxIncludedBytes = std::size_t{16} << 30;

[[noreturn]] void fail_reading(const std::string& path, int error) {
    throw std::system_error(error, std::generic_category(), "can't read " + in_quotes(path));
}

std::string read_stream(const std::string& path, std::istream& stream, std::size_t expected_size) {
    constexpr std::size_t kBlock = 1 << 20;
    if (expected_size > kMaxSize) fail_reading(path, EFBIG);
    std::string text;
    text.reserve(expected_size + 1);
    std::size_t size = 0;
    while (stream) {
        if (size > kMaxSize) fail_reading(path, EFBIG);
        // One byte more than there should be, to meet the end.
        const std::size_t missing = expected_size + 1 > size ? expected_size + 1 - size : kBlock;
        const std::size_t block = std::min(missing, kBlock);
        text.resize(size + block);
        stream.read(text.data() + size, static_cast<std::streamsize>(block));
        size += static_cast<std::size_t>(stream.gcount());
    }
    text.resize(size);
    if (size < kBlock) text.shrink_to_fit();  // there may be many small files
    return text;
}

/// Names that lead to one file compare equal.
const fs::path& identity(const std::string& name, IncludedSum& sum) {
    const auto [entry, is_new] = sum.identities.try_emplace(name);
    std::error_code ignored;
    if (is_new) entry->second = fs::weakly_canonical(name, ignored);
    return entry->second;
}

/// "a.lxs -> b.lxs -> a.lxs": how `file` comes to include `name` again, from `last` on.
std::string cycle_text(const SourceFile& file, const SourceFile& last, const std::string& name) {
    std::string text = in_quotes(name);
    for (const SourceFile* f = &file;; f = f->included_by.get()) {
        text.insert(0, in_quotes(f->name) + " -> ");
        if (f == &last) return text;
    }
}

void check_chain(const Name& include, const std::string& path, IncludedSum& sum) {
    const fs::path& own = identity(path, sum);
    int depth = 1;
    for (const SourceFile* f = include.where.file.get(); f; f = f->included_by.get(), ++depth) {
        if (identity(f->name, sum) == own) {
            throw InputError(include.where, "Include leads in a circle: " +
                                                cycle_text(*include.where.file, *f, path));
        }
    }
    if (depth - 1 > kMaxIncludeDepth) {
        throw InputError(include.where, "Include nests deeper than " +
                                            std::to_string(kMaxIncludeDepth) + " levels");
    }
}

}  // namespace

std::string read_text(const std::string& path) {
    if (path == "-") return read_stream(path, std::cin, 0);
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) fail_reading(path, EISDIR);
    errno = 0;
    std::ifstream stream(path, std::ios::binary);
    if (!stream) fail_reading(path, errno != 0 ? errno : EIO);
    const std::uintmax_t size = fs::file_size(path, ignored);
    std::string text = read_stream(path, stream, ignored ? 0 : size);
    if (stream.bad()) fail_reading(path, errno != 0 ? errno : EIO);
    return text;
}

std::shared_ptr<const SourceFile> source_of(std::string text, std::string name) {
    auto file = std::make_shared<SourceFile>();
    file->name = std::move(name);
    file->text = std::make_shared<const std::string>(std::move(text));
    return file;
}

std::shared_ptr<const SourceFile> open_include(const Name& file, AssetFinder& finder,
                                               IncludedSum& sum, Diagnostics& diagnostics) {
    std::string path;
    try {
        path = finder.find(file.text, file.where, diagnostics);
    } catch (const InputError& error) {
        throw IgnoredStatement(error.where(), error.message());
    }
    check_chain(file, path, sum);
    auto source = std::make_shared<SourceFile>();
    source->name = path;
    source->included_by = file.where.file;
    source->include_line = file.where.line;
    try {
        source->text = std::make_shared<const std::string>(read_text(path));
    } catch (const std::system_error& error) {
        throw IgnoredStatement(file.where, error.what());
    }
    ++sum.files;
    sum.bytes += source->text->size();
    if (sum.files > kMaxIncludes || sum.bytes > kMaxIncludedBytes) {
        throw EndOfReading(file.where, "Include reads more than " + std::to_string(kMaxIncludes) +
                                           " files or 16 GiB, counting each as often as it is "
                                           "included");
    }
    return source;
}

std::optional<std::string_view> first_word(std::string_view scene) {
    namespace peg = tao::pegtl;
    struct Beginning : peg::seq<peg::opt<peg::utf8::bom>, grammar::Gap> {};
    peg::memory_input<peg::tracking_mode::lazy, peg::eol::lf> in(scene.data(),
                                                                 scene.data() + scene.size(), "");
    peg::parse<Beginning>(in);
    if (in.empty()) return std::nullopt;
    const char* const begin = in.current();
    peg::parse<grammar::Word>(in);
    return std::string_view(begin, static_cast<std::size_t>(in.current() - begin));
}

}  // namespace lxs
