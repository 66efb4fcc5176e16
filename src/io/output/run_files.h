// Checks the files of a run before the work: nothing that is read is written, and each output has a
// file of its own.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace resect {

struct OutputFile {
  std::string option;          // as the user gave it: "--surface"
  std::filesystem::path path;  // "" = not wanted; "-" = standard output
};

// Files of a folder that are numbered from 1 on: frame_0001.png, piece_1.stl.
struct NumberedOutputs {
  std::string option;             // "--frames"
  std::filesystem::path folder;   // "" = not wanted
  std::string before, extension;  // of a name: "frame_", ".png"
};

struct RunOutputs {
  std::vector<OutputFile> files;
  std::vector<NumberedOutputs> folders = {};
  bool overwrite = false;  // numbered files of an earlier run may be removed
};

// Throws, before anything is written or removed:
//   a usage Error when an output is one of the inputs, or two outputs are one file, by whatever
//   names (identityOf() in io/output/output_target.h); inputs that do not exist are ignored;
//   an Error when an output cannot be written (findTarget()), or a folder holds numbered files of
//   an earlier run and `overwrite` is not set.
void checkOutputs(const RunOutputs& outputs, std::span<const std::filesystem::path> inputs = {});

// The numbered files that are there, sorted: ordinary files and links whose names have digits alone
// between `before` and `extension`.
std::vector<std::filesystem::path> numberedFiles(const NumberedOutputs& outputs);

// Removes numberedFiles() and nothing else; a link, not what it leads to. To be called after
// checkOutputs(), when the first of the new ones is about to be written.
void removeNumberedFiles(const NumberedOutputs& outputs);

}  // namespace resect
