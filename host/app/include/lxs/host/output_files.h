// Where the outputs of a render go.
#pragma once

#include <string>

#include "lxs/host/command_line.h"
#include "lxs/imaging/imaging.h"

namespace lxs {

struct OutputFiles {
    std::string exr;
    std::string png;
    std::string statistics;  ///< empty: none
};

/// `-o`, else the film's file name, in the current folder.
OutputFiles choose_output_files(const CommandLine& command, const FileFilm& film);

/// Throws OutputFailure unless a file can be written there, found out by writing one beside it;
/// removes what a killed process has left beside it.
void check_writable(const std::string& path);
/// Throws OutputFailure unless all files can be written, found out by writing a file beside them.
void check_writable(const OutputFiles& files);

/// Writes EXR and PNG; throws OutputFailure.
void write_images(const OutputFiles& files, const FileFilm& film, const ImageMetadata& metadata);

}  // namespace lxs
