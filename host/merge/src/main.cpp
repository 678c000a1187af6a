// lxsmerge: joins renders of one scene that differ in their seeds.
#include "lxs/host/process_faults.h"
#include "lxs/merge/merge_command.h"

int main(int argc, char** argv) {
    lxs::receive_faults_as_errors();
    return static_cast<int>(lxs::run_lxsmerge(argc, argv));
}
