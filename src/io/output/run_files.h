// Checks the files of a run before its work begins: no output may be an input, and no two outputs
// may be the same file.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace resect {

struct OutputFile {
  std::string option;          // command-line option that gives the path: "--surface"
  std::filesystem::path path;  // "" = not wanted; "-" = standard output
};

// Output files in one folder, numbered from 1 on: frame_0001.png, piece_1.stl.
struct NumberedOutputs {
  std::string option;             // "--frames"
  std::filesystem::path folder;   // "" = not wanted
  std::string before, extension;  // beginning and end of the names: "frame_", ".png"
};

struct RunOutputs {
  std::vector<OutputFile> files;
  std::vector<NumberedOutputs> folders = {};
  bool overwrite = false;  // numbered files of an earlier run may be removed
};

// Throws, before anything is written or removed:
// - a usage Error if an output is one of the inputs, or if two outputs are the same file, whatever
//   their names (identityOf() in io/output/output_target.h). Inputs that do not exist are ignored.
// - an Error if an output cannot be written (findTarget()), or if a folder holds numbered files of
//   an earlier run and `overwrite` is not set.
void checkOutputs(const RunOutputs& outputs, std::span<const std::filesystem::path> inputs = {});

// The numbered files that exist, sorted. These are the ordinary files and the links whose names
// have only digits between `before` and `extension`.
std::vector<std::filesystem::path> numberedFiles(const NumberedOutputs& outputs);

// Removes the files of numberedFiles(). If one is a link, removes the link and keeps the file that
// it leads to. To be called after checkOutputs(), just before the first new file is written.
void removeNumberedFiles(const NumberedOutputs& outputs);

}  // namespace resect
