// One record a process, as a shared library: the program and its plugins write to the same.
#include "work_record.h"

#include <cxxabi.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>
#include <sched.h>
#include <time.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <optional>
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

std::int64_t nanoseconds(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

/// Processor time of the thread, so that others' work on the machine does not count; for walls the
/// time on the clock.
std::int64_t now(Mode mode) {
    return nanoseconds(mode == Mode::Tasks ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC);
}

std::string readable(const char* name) {
    int status = 0;
    const std::unique_ptr<char, decltype(&std::free)> text(
        abi::__cxa_demangle(name, nullptr, nullptr, &status), &std::free);
    return status == 0 ? text.get() : name;
}

std::string environment(const char* variable) {
    const char* value = std::getenv(variable);
    return value ? value : "";
}

/// Processors that this thread may be on, one by one, as some are slower at times than others.
class Processors {
  public:
    Processors() { sched_getaffinity(0, sizeof all_, &all_); }

    void next() {
        do
            last_ = (last_ + 1) % CPU_SETSIZE;
        while (!CPU_ISSET(last_, &all_));
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(last_, &one);
        sched_setaffinity(0, sizeof one, &one);
    }
    void any() const { sched_setaffinity(0, sizeof all_, &all_); }

  private:
    cpu_set_t all_{};
    int last_ = -1;
};

/// Passes of a render, every second one on a single thread, which is on each processor in turn.
class Turns {
  public:
    /// `alone`: 0 if even passes are on a single thread, 1 if odd ones are.
    Turns(std::string mark, std::size_t alone) : mark_(std::move(mark)), alone_(alone) {}

    void loop_begins(const Loop& loop) {
        if (!is_mark(loop.body)) return;
        const bool alone = begins_.size() % 2 == alone_;
        begins_.push_back(
            {alone, nanoseconds(CLOCK_MONOTONIC), nanoseconds(CLOCK_PROCESS_CPUTIME_ID)});
        if (alone) {
            single_.emplace(oneapi::tbb::global_control::max_allowed_parallelism, 1);
            processors_.next();
        } else {
            single_.reset();
            processors_.any();
        }
    }

    void write(std::ostream& out) const {
        out << ",\n\"passes\": [";
        for (std::size_t i = 0; i + 1 < begins_.size(); ++i)
            out << (i ? ", " : "") << '[' << (begins_[i].alone ? 1 : 0) << ", "
                << begins_[i + 1].wall - begins_[i].wall << ", "
                << begins_[i + 1].processor - begins_[i].processor << ']';
        out << ']';
    }

  private:
    struct Begin {
        bool alone = false;
        std::int64_t wall = 0, processor = 0;  // nanoseconds; of all threads
    };

    bool is_mark(const std::type_info& body) {
        const auto [found, fresh] = marks_.try_emplace(body.name(), false);
        if (fresh) found->second = readable(body.name()).find(mark_) != std::string::npos;
        return found->second;
    }

    std::string mark_;
    std::size_t alone_ = 0;
    std::unordered_map<const char*, bool> marks_;
    std::vector<Begin> begins_;
    std::optional<oneapi::tbb::global_control> single_;
    Processors processors_;
};

class Record {
  public:
    Record() {
        const std::string wish = environment("AIPS_WORK_RECORD");
        const std::size_t colon = wish.find(':');
        if (colon == std::string::npos) return;
        const std::string mode = wish.substr(0, colon);
        file_ = wish.substr(colon + 1);
        if (mode == "tasks") mode_ = Mode::Tasks;
        if (mode == "walls") mode_ = Mode::Walls;
        if (mode == "even" || mode == "odd") {
            mode_ = Mode::Walls;
            turns_.emplace(environment("AIPS_WORK_MARK"), mode == "odd" ? 1 : 0);
        }
    }
    ~Record() {
        if (mode_ == Mode::Nothing) return;
        std::ofstream out(file_);
        write(out);
        if (!out.flush()) std::fprintf(stderr, "cannot write %s\n", file_.c_str());
    }
    Record(const Record&) = delete;
    Record& operator=(const Record&) = delete;

    Mode mode() const { return mode_; }
    /// Loops of other threads than the first, and loops within loops, are part of their caller.
    bool takes() const { return !within_ && std::this_thread::get_id() == thread_; }

    void add(const Loop& loop, const std::function<void(Entry&)>& work) {
        if (turns_) turns_->loop_begins(loop);
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
    void write(std::ostream& out) const;

    Mode mode_ = Mode::Nothing;
    std::string file_;
    std::optional<Turns> turns_;
    std::thread::id thread_ = std::this_thread::get_id();
    bool within_ = false, within_pair_ = false;
    std::unordered_map<std::string, std::size_t> names_;
    std::vector<Entry> entries_;
    std::vector<Pair> pairs_;
};

void Record::write(std::ostream& out) const {
    std::vector<std::string> names(names_.size());
    for (const auto& [name, number] : names_)
        names[number] = readable(name.c_str());
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
    out << ']';
    if (turns_) turns_->write(out);
    out << "}\n";
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
