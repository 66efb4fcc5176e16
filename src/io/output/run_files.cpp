#include "io/output/run_files.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/error.h"
#include "io/output/output_target.h"

namespace resect {
namespace {

namespace fs = std::filesystem;

bool isNumbered(const std::string& name, const NumberedOutputs& outputs) {
  if (name.size() <= outputs.before.size() + outputs.extension.size()) return false;
  if (!name.starts_with(outputs.before) || !name.ends_with(outputs.extension)) return false;
  const auto digits = name.substr(outputs.before.size(),
                                  name.size() - outputs.before.size() - outputs.extension.size());
  return std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
}

// Whether the name is one of those that will be written to the folder.
bool isAmong(const fs::path& name, const NumberedOutputs& outputs) {
  if (!isNumbered(name.filename().string(), outputs)) return false;
  const fs::path parent = name.parent_path();
  return identityOf(parent.empty() ? "." : parent) == identityOf(outputs.folder);
}

// The first folder on the way to the name that is itself to be written as a file; empty if none.
fs::path blockedBy(const fs::path& name, const std::map<std::string, const OutputFile*>& written) {
  std::error_code ec;
  fs::path folder = fs::absolute(name, ec);
  while (folder.has_relative_path()) {
    folder = folder.parent_path();
    const auto found = written.find(identityOf(folder));
    if (found != written.end()) return found->second->path;
  }
  return {};
}

using Identities = std::set<std::string>;

void checkFolder(const NumberedOutputs& outputs, const Identities& inputs, bool overwrite) {
  findTarget(outputs.folder / (outputs.before + "1" + outputs.extension));
  const std::vector<fs::path> there = numberedFiles(outputs);
  for (const fs::path& file : there)
    if (inputs.contains(identityOf(file)))
      throw usageError(
          "{} is read and would be overwritten by {}; choose another folder to write to",
          file.string(), outputs.option);
  if (!there.empty() && !overwrite)
    throw error(
        "{} holds {} of an earlier run{}; give {} another folder, or remove them with --overwrite",
        outputs.folder.string(), there.front().filename().string(),
        there.size() == 1 ? "" : fmt::format(" and {} more such files", there.size() - 1),
        outputs.option);
}

}  // namespace

void checkOutputs(const RunOutputs& outputs, std::span<const fs::path> inputs) {
  Identities read;
  for (const fs::path& input : inputs) {
    std::error_code ec;
    if (fs::exists(input, ec)) read.insert(identityOf(input));
  }
  std::map<std::string, const OutputFile*> written;
  for (const OutputFile& output : outputs.files) {
    if (output.path.empty()) continue;
    const std::string identity = identityOf(output.path);
    if (read.contains(identity))
      throw usageError("{} is read and would be overwritten; choose another name to write to",
                       output.path.string());
    if (output.path != "-") findTarget(output.path);
    if (identity.empty()) continue;
    if (const auto [other, first] = written.emplace(identity, &output); !first)
      throw usageError("{} and {} would both be written to {}; give each a name of its own",
                       other->second->option, output.option,
                       output.path == "-" ? "standard output" : output.path.string());
    for (const NumberedOutputs& folder : outputs.folders)
      if (!folder.folder.empty() && isAmong(output.path, folder))
        throw usageError("{} has the name of a file that {} writes; give {} another name",
                         output.path.string(), folder.option, output.option);
  }
  for (const NumberedOutputs& folder : outputs.folders) {
    if (folder.folder.empty()) continue;
    if (const fs::path file = blockedBy(folder.folder / "1", written); !file.empty())
      throw usageError("{} is a file to write and on the way to the folder of {}; choose another",
                       file.string(), folder.option);
    checkFolder(folder, read, outputs.overwrite);
  }
  for (const OutputFile& output : outputs.files)
    if (!output.path.empty() && output.path != "-")
      if (const fs::path file = blockedBy(output.path, written); !file.empty())
        throw usageError("{} is a file to write and on the way to {}; choose another name",
                         file.string(), output.path.string());
}

std::vector<fs::path> numberedFiles(const NumberedOutputs& outputs) {
  std::vector<fs::path> files;
  std::error_code ec;
  fs::directory_iterator entries(outputs.folder, ec);
  for (; !ec && entries != fs::directory_iterator(); entries.increment(ec)) {
    const bool ordinary = entries->is_symlink(ec) || entries->is_regular_file(ec);
    if (ordinary && isNumbered(entries->path().filename().string(), outputs))
      files.push_back(entries->path());
  }
  std::ranges::sort(files);
  return files;
}

void removeNumberedFiles(const NumberedOutputs& outputs) {
  for (const fs::path& file : numberedFiles(outputs)) {
    std::error_code ec;
    if (!fs::remove(file, ec) && ec)
      throw error("cannot remove {}: {}; choose another folder", file.string(), ec.message());
  }
}

}  // namespace resect
