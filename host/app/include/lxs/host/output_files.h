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

/// `-o`, else the film's file name, in the current folder. NAME.png means the PNG alone, any other
/// name the EXR and a PNG beside it.
OutputFiles choose_output_files(const CommandLine& command, const FileFilm& film);

/// Throws OutputFailure unless a file can be written there, found out by writing one beside it;
/// removes what a killed process has left beside it.
void check_writable(const std::string& path);
/// Throws OutputFailure unless all files can be written, found out by writing a file beside them.
void check_writable(const OutputFiles& files);

/// "a.exr and a.png", those that are written.
std::string names_of_images(const OutputFiles& files);

/// Writes EXR and PNG, each to another place if it can't be written where it should be (rescue.h).
/// True if both are where they should be.
bool write_images(const OutputFiles& files, const FileFilm& film, const ImageMetadata& metadata,
                  ConsoleLog& log);

}  // namespace lxs
