// Faults that the system would end the process for, turned into errors that can be reported.
#pragma once

namespace lxs {

/// For the program lxsrender, before anything else: a file beyond the size limit (SIGXFSZ) and a
/// closed pipe (SIGPIPE) become errors of the write that met them, and an exception that nobody can
/// catch (thrown by a thread of a library, or while another one is in flight) ends the process with
/// a message and exit code 1 instead of abort().
void receive_faults_as_errors();

}  // namespace lxs
