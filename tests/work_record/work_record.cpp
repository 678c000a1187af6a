// One record a process, as a shared library: the program and its plugins write to the same.
#include "work_record.h"

#include <cxxabi.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>
#include <time.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <unordered_map>
#include <vector>

namespace work_record {
namespace {

/// More pieces than any number of cores needs that is reckoned with, and few enough to look at the
/// clock for each.
constexpr std::size_t kMostPieces = 2048;

enum class Mode { Nothing, Tasks, Walls };

struct Entry {
    std::size_t name = 0;
    std::int64_t begin = 0, end = 0;   // nanoseconds
    std::vector<std::uint32_t> tasks;  // nanoseconds; of walls none
};

/// Two parts of the work that may go on at the same time: each its entries, and its time.
struct Pair {
    std::size_t first = 0, second = 0, end = 0;                  // entry that it begins with
    std::int64_t first_time = 0, second_time = 0, end_time = 0;  // nanoseconds
};

/// Processor time of the thread, so that others' work on the machine does not count; for walls the
/// time on the clock.
std::int64_t now(Mode mode) {
    timespec time{};
    clock_gettime(mode == Mode::Tasks ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC, &time);
    return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

std::string readable(const char* name) {
    int status = 0;
    const std::unique_ptr<char, decltype(&std::free)> text(
        abi::__cxa_demangle(name, nullptr, nullptr, &status), &std::free);
    return status == 0 ? text.get() : name;
}

class Record {
  public:
    Record() {
        const char* variable = std::getenv("AIPS_WORK_RECORD");
        const std::string wish = variable ? variable : "";
        if (wish.starts_with("tasks:")) mode_ = Mode::Tasks;
        if (wish.starts_with("walls:")) mode_ = Mode::Walls;
        if (mode_ != Mode::Nothing) file_ = wish.substr(6);
    }
    ~Record() {
        if (mode_ != Mode::Nothing) write();
    }
    Record(const Record&) = delete;
    Record& operator=(const Record&) = delete;

    Mode mode() const { return mode_; }
    /// Loops of other threads than the first, and loops within loops, are part of their caller.
    bool takes() const { return !within_ && std::this_thread::get_id() == thread_; }

    void add(const Loop& loop, const std::function<void(Entry&)>& work) {
        const std::int64_t begin = now(mode_);
        Entry entry{name(loop.body), begin, 0, {}};
        within_ = true;
        work(entry);
        within_ = false;
        entries_.push_back(std::move(entry));
        entries_.back().end = now(mode_);
    }

    void add_pair(const std::function<void()>& first, const std::function<void()>& second) {
        Pair pair{entries_.size(), 0, 0, now(mode_), 0, 0};
        within_pair_ = true;
        first();
        pair.second = entries_.size();
        pair.second_time = now(mode_);
        second();
        pair.end = entries_.size();
        pair.end_time = now(mode_);
        within_pair_ = false;
        pairs_.push_back(pair);
    }
    bool takes_pairs() const { return takes() && !within_pair_; }

  private:
    std::size_t name(const std::type_info& body) {
        return names_.try_emplace(body.name(), names_.size()).first->second;
    }
    void write() const;

    Mode mode_ = Mode::Nothing;
    std::string file_;
    std::thread::id thread_ = std::this_thread::get_id();
    bool within_ = false, within_pair_ = false;
    std::unordered_map<std::string, std::size_t> names_;
    std::vector<Entry> entries_;
    std::vector<Pair> pairs_;
};

void Record::write() const {
    std::vector<std::string> names(names_.size());
    for (const auto& [name, number] : names_)
        names[number] = readable(name.c_str());
    std::ofstream out(file_);
    out << "{\"clock\": \"" << (mode_ == Mode::Tasks ? "processor" : "wall") << "\", \"names\": [";
    for (std::size_t i = 0; i < names.size(); ++i)
        out << (i ? ", " : "") << '"' << names[i] << '"';
    out << "],\n\"loops\": [";
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const Entry& entry = entries_[i];
        out << (i ? ",\n" : "\n") << '[' << entry.name << ", " << entry.begin << ", " << entry.end
            << ", [";
        for (std::size_t t = 0; t < entry.tasks.size(); ++t)
            out << (t ? "," : "") << entry.tasks[t];
        out << "]]";
    }
    out << "],\n\"pairs\": [";
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        const Pair& pair = pairs_[i];
        out << (i ? ",\n" : "\n") << '[' << pair.first << ", " << pair.second << ", " << pair.end
            << ", " << pair.first_time << ", " << pair.second_time << ", " << pair.end_time << ']';
    }
    out << "]}\n";
    if (!out.flush()) std::fprintf(stderr, "cannot write %s\n", file_.c_str());
}

Record& record() {
    static Record only;
    return only;
}

void work_on_threads(const Loop& loop, const Piece& piece) {
    const oneapi::tbb::blocked_range<std::size_t> range(0, loop.items, loop.grain);
    oneapi::tbb::parallel_for(range, [&](const auto& part) { piece(part.begin(), part.end()); });
}

void work_piece_by_piece(const Loop& loop, const Piece& piece, std::vector<std::uint32_t>& tasks) {
    const std::size_t size = std::max(loop.grain, (loop.items + kMostPieces - 1) / kMostPieces);
    tasks.reserve((loop.items + size - 1) / size);
    std::int64_t begin = now(Mode::Tasks);
    for (std::size_t first = 0; first < loop.items; first += size) {
        piece(first, std::min(first + size, loop.items));
        const std::int64_t end = now(Mode::Tasks);
        tasks.push_back(static_cast<std::uint32_t>(end - begin));
        begin = end;
    }
}

}  // namespace

void run(const Loop& loop, const Piece& piece) {
    Record& record = work_record::record();
    if (record.mode() == Mode::Nothing || !record.takes()) {
        work_on_threads(loop, piece);
    } else if (record.mode() == Mode::Walls) {
        record.add(loop, [&](Entry& /*entry*/) { work_on_threads(loop, piece); });
    } else {
        record.add(loop, [&](Entry& entry) { work_piece_by_piece(loop, piece, entry.tasks); });
    }
}

void run_beside(const std::type_info& body, const std::function<void()>& first,
                const std::function<void()>& second) {
    Record& record = work_record::record();
    const auto on_threads = [&] { oneapi::tbb::parallel_invoke(first, second); };
    if (record.mode() == Mode::Tasks && record.takes_pairs()) {
        record.add_pair(first, second);
    } else if (record.mode() == Mode::Walls && record.takes()) {
        record.add({body}, [&](Entry& /*entry*/) { on_threads(); });
    } else if (record.mode() == Mode::Tasks && record.takes()) {
        first();
        second();
    } else {
        on_threads();
    }
}

}  // namespace work_record
