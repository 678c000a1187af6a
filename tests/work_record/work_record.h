// Records the parallel loops of a program: from when to when each ran, and how long each of its
// pieces took. scripts/scaling reckons from this what more cores would bring.
#pragma once

#include <cstddef>
#include <functional>
#include <typeinfo>

namespace work_record {

struct Loop {
    const std::type_info& body;  ///< its name tells the function that the loop is in
    std::size_t items = 0;
    std::size_t grain = 1;  ///< ranges of up to so many items are not divided
};

/// Works on the items [first, last).
using Piece = std::function<void(std::size_t first, std::size_t last)>;

/// Works on all items of a loop. What is recorded depends on the environment variable
/// AIPS_WORK_RECORD, which is MODE:FILE; FILE is written when the program ends.
/// tasks: pieces are worked on one by one, and the processor time of each is recorded.
/// walls: pieces are worked on by oneTBB's threads, and the time on the clock of each loop is
/// recorded.
/// even, odd: as walls, but of passes the even or the odd ones are on a single thread, which is on
/// each processor in turn; the time of each pass is recorded, and the processor time of all
/// threads. A pass begins with a loop in the function AIPS_WORK_MARK. Without the variable oneTBB
/// does the same as for walls and nothing is recorded.
void run(const Loop& loop, const Piece& piece);

/// Does both, each with loops of its own. tasks: one after the other, and which loops were whose is
/// recorded. walls: as one loop of the name of `body`. Pairs within pairs are part of their caller.
void run_beside(const std::type_info& body, const std::function<void()>& first,
                const std::function<void()>& second);

}  // namespace work_record
