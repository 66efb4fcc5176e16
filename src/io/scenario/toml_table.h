// A checked TOML table: values with their ranges, and Errors with file, line and key.
//
// Wraps one toml++ table. Every value that is read is checked for type and range.
// refuseUnknownKeys() throws Error for keys that were never read, so that a misspelt key is not
// silently ignored.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "geometry/pose.h"

namespace toml {
inline namespace v3 {
class table;
class node;
}  // namespace v3
}  // namespace toml

namespace resect {

class TomlTable {
 public:
  static TomlTable readFile(const std::filesystem::path& path);
  // `name` stands for a file in Errors.
  static TomlTable parse(const std::string& text, const std::string& name);

  bool has(const std::string& key) const;
  // A missing key gives the default, `missing`; if there is no default, it is an Error.
  double number(const std::string& key, double low, double high,
                std::optional<double> missing = {}) const;
  int integer(const std::string& key, int low, int high, std::optional<int> missing = {}) const;
  std::string text(const std::string& key, std::optional<std::string> missing = {}) const;
  bool flag(const std::string& key, bool missing) const;
  Vec3 vec3(const std::string& key, std::optional<Vec3> missing = {}) const;
  std::vector<double> numbers(const std::string& key, double low,
                              double high) const;          // [1, 2, ...]; empty when missing
  std::vector<Vec3> points(const std::string& key) const;  // [[x, y, z], ...]; empty when missing
  std::vector<std::string> texts(const std::string& key) const;  // empty when missing
  double length(const std::string& key, double low,
                double high) const;  // "5mm", or a number of metres
  // { axis = [x, y, z], degrees = 30 }, or { handle = [...], edge = [...] }: directions of a tool's
  // handle (+Z of its frame) and edge (-Y). Identity if missing.
  Eigen::Quaterniond rotation(const std::string& key) const;

  std::optional<TomlTable> table(const std::string& key) const;
  bool isList(const std::string& key) const;
  std::vector<TomlTable> tables(
      const std::string& key) const;  // [[key]] or key = [{...}, ...]; empty when missing

  std::vector<std::string> keys() const;  // of this table, not of tables in it; sorted

  // Throws Error if this table has a key that was not read; tables in it are not looked at.
  void refuseUnknownKeys() const;
  // Throws Error: file, line and key, then the sentence.
  [[noreturn]] void complain(const std::string& key, const std::string& sentence) const;
  const std::string& file() const { return file_; }

 private:
  TomlTable(std::shared_ptr<const toml::table> root, const toml::table* table, std::string file,
            std::string path);
  const toml::node* find(const std::string& key) const;
  std::string where(const toml::node* node) const;
  Vec3 toVec3(const toml::node& node, const std::string& key) const;

  std::shared_ptr<const toml::table> root_;  // keeps the document alive
  const toml::table* table_;
  std::string file_, path_;
  std::shared_ptr<std::set<std::string>> asked_;
};

}  // namespace resect
