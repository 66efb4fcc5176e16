// Finds optional data files (a real liver, expected values).
#pragma once

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

namespace resect::test {

// The file under RESECT_SHARED, or under ../shared beside the sources; nothing, and a line
// "skipped", when it is missing.
inline std::optional<std::filesystem::path> sharedData(const std::string& name) {
  const char* env = std::getenv("RESECT_SHARED");
  const std::filesystem::path root =
      env ? std::filesystem::path(env) : std::filesystem::path(RESECT_SOURCE_DIR) / ".." / "shared";
  const auto path = root / "data" / name;
  if (std::filesystem::exists(path)) return path;
  MESSAGE("skipped: optional data file data/" << name << " is not here");
  return std::nullopt;
}

}  // namespace resect::test
