// Where the outputs of a render go.
#pragma once

#include <string>

#include "lxs/host/command_line.h"
#include "lxs/host/console_log.h"
#include "lxs/imaging/imaging.h"

namespace lxs {

/// Empty: none is written.
struct OutputFiles {
    std::string exr;
    std::string png;
    std::string statistics;
};

/// Whether a file's name ends in `suffix` (".png"), in letters of either case.
bool has_suffix(const std::string& name, const std::string& suffix);

/// `-o`, else the film's file name, in the current folder or below: what else it says is left out,
/// with a warning. NAME.png means the PNG alone, any other name the EXR and a PNG beside it. Throws
/// OutputFailure if links lead from the film's name out of the current folder.
OutputFiles choose_output_files(const CommandLine& command, const FileFilm& film, ConsoleLog& log);

/// Throws OutputFailure unless a file can be written there, found out by making one beside it as
/// writing will; warns if that can't be locked. Removes what a killed process has left beside it.
/// Nothing, if `path` is empty.
void check_writable(const std::string& path, ConsoleLog& log);

/// "a.exr and a.png", those that are written.
std::string names_of_images(const OutputFiles& files);

/// Writes EXR and PNG, each to another place if it can't be written where it should be (rescue.h).
/// True if both are where they should be.
bool write_images(const OutputFiles& files, const FileFilm& film, const ImageMetadata& metadata,
                  ConsoleLog& log);

}  // namespace lxs
