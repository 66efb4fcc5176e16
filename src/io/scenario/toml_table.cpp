#include "io/scenario/toml_table.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>
#include <sstream>
#include <stdexcept>

// Some texts violate the parser's assertions (3.3: a key that begins with an invalid character),
// which would abort the program, or be undefined behaviour in an optimised build; here an assertion
// throws.
namespace {
[[noreturn]] void refuseText() { throw std::logic_error("a key or value is cut short"); }
}  // namespace
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(condition) ((condition) ? void(0) : refuseText())
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

#include "base/error.h"
#include "geometry/rotation.h"
#include "io/scenario/length.h"
#include "io/scenario/toml_limits.h"
#include "io/whole_file.h"

namespace resect {

TomlTable::TomlTable(std::shared_ptr<const toml::table> root, const toml::table* table,
                     std::string file, std::string path)
    : root_(std::move(root)),
      table_(table),
      file_(std::move(file)),
      path_(std::move(path)),
      asked_(std::make_shared<std::set<std::string>>()) {}

TomlTable TomlTable::readFile(const std::filesystem::path& path) {
  std::error_code ec;
  if (!std::filesystem::is_regular_file(path, ec))
    throw error("cannot read {}: there is no such file; check the name", path.string());
  return parse(readWholeFile(path, kMostTomlBytes), path.string());
}

namespace {

// The line at whose end the parser's assertions fail first: the parser reads forwards, so that they
// fail for each longer beginning of the text too.
int lineRefused(std::string_view text) {
  const auto fails = [&](std::size_t bytes) {
    try {
      static_cast<void>(toml::parse(text.substr(0, bytes)));
    } catch (const toml::parse_error&) {
    } catch (const std::logic_error&) {
      return true;
    }
    return false;
  };
  std::vector<std::size_t> ends;  // of the lines
  for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos;) ends.push_back(++at);
  return int(std::ranges::partition_point(ends, std::not_fn(fails)) - ends.begin()) + 1;
}

}  // namespace

TomlTable TomlTable::parse(const std::string& text, const std::string& name) {
  requireParsable(text, name);
  try {
    auto root = std::make_shared<toml::table>(toml::parse(text, name));
    const toml::table* top = root.get();
    return TomlTable(std::move(root), top, name, "");
  } catch (const toml::parse_error& e) {
    std::string what(e.description());
    for (char& c : what)
      if (static_cast<unsigned char>(c) < 32) c = ' ';
    throw error("{}:{}: {}; correct the line", name, e.source().begin.line, what);
  } catch (const std::logic_error& e) {  // from refuseText()
    throw error("{}:{}: {}; correct the line", name, lineRefused(text), e.what());
  }
}

const toml::node* TomlTable::find(const std::string& key) const {
  asked_->insert(key);
  return table_->get(key);
}

std::string TomlTable::where(const toml::node* node) const {
  const auto line = (node ? node->source() : table_->source()).begin.line;
  return line > 0 ? fmt::format("{}:{}", file_, line) : file_;
}

void TomlTable::complain(const std::string& key, const std::string& sentence) const {
  throw error("{}: {}{} {}", where(table_->get(key)), path_, key, sentence);
}

bool TomlTable::has(const std::string& key) const { return find(key) != nullptr; }

double TomlTable::number(const std::string& key, double low, double high,
                         std::optional<double> missing) const {
  const toml::node* node = find(key);
  if (!node && missing) return *missing;
  if (!node) complain(key, fmt::format("is missing; give a number from {:g} to {:g}", low, high));
  const auto value = node->value<double>();
  if (!node->is_number() || !value || !(*value >= low && *value <= high))
    complain(key, fmt::format("is no number from {:g} to {:g}", low, high));
  return *value;
}

int TomlTable::integer(const std::string& key, int low, int high,
                       std::optional<int> missing) const {
  const toml::node* node = find(key);
  if (!node && missing) return *missing;
  if (!node) complain(key, fmt::format("is missing; give a whole number from {} to {}", low, high));
  const auto value = node->value<std::int64_t>();
  if (!node->is_integer() || !value || *value < low || *value > high)
    complain(key, fmt::format("is no whole number from {} to {}", low, high));
  return int(*value);
}

std::string TomlTable::text(const std::string& key, std::optional<std::string> missing) const {
  const toml::node* node = find(key);
  if (!node && missing) return *missing;
  if (!node) complain(key, "is missing; give a text in quotes");
  if (!node->is_string()) complain(key, "is no text in quotes");
  return toText(*node, key);
}

std::string TomlTable::freeText(const std::string& key) const {
  const toml::node* node = find(key);
  if (node && !node->is_string()) complain(key, "is no text in quotes");
  return node ? *node->value<std::string>() : "";
}

std::string TomlTable::toText(const toml::node& node, const std::string& key) const {
  std::string text = *node.value<std::string>();
  if (text.find_first_not_of(" \t\r\n") == text.npos)
    complain(key, "is empty; give a text, or leave the key out");
  return text;
}

bool TomlTable::flag(const std::string& key, bool missing) const {
  const toml::node* node = find(key);
  if (!node) return missing;
  if (!node->is_boolean()) complain(key, "is neither true nor false");
  return *node->value<bool>();
}

Vec3 TomlTable::toVec3(const toml::node& node, const std::string& key, double farthest) const {
  const toml::array* array = node.as_array();
  Vec3 v;
  bool good = array && array->size() == 3;
  for (std::size_t a = 0; good && a < 3; ++a) {
    const auto value = (*array)[a].value<double>();
    good =
        (*array)[a].is_number() && value && std::isfinite(*value) && std::abs(*value) <= farthest;
    if (good) v[Eigen::Index(a)] = *value;
  }
  if (!good)
    complain(key,
             fmt::format("is not three finite numbers [x, y, z] from -{0:g} to {0:g}", farthest));
  return v;
}

Vec3 TomlTable::vec3(const std::string& key, std::optional<Vec3> missing) const {
  const toml::node* node = find(key);
  if (!node && missing) return *missing;
  if (!node) complain(key, "is missing; give three numbers [x, y, z]");
  return toVec3(*node, key);
}

Vec3 TomlTable::place(const std::string& key, double farthest, std::optional<Vec3> missing) const {
  const toml::node* node = find(key);
  if (!node && missing) return *missing;
  if (!node) complain(key, "is missing; give three numbers [x, y, z]");
  return toVec3(*node, key, farthest);
}

std::vector<double> TomlTable::numbers(const std::string& key, double low, double high) const {
  std::vector<double> result;
  const toml::node* node = find(key);
  if (!node) return result;
  if (!node->is_array()) complain(key, "is no list of numbers [a, b, ...]");
  for (const toml::node& element : *node->as_array()) {
    const auto value = element.value<double>();
    if (!element.is_number() || !value || !(*value >= low && *value <= high))
      complain(key, fmt::format("holds something that is no number from {:g} to {:g}", low, high));
    result.push_back(*value);
  }
  return result;
}

std::vector<Vec3> TomlTable::points(const std::string& key, double farthest) const {
  std::vector<Vec3> result;
  const toml::node* node = find(key);
  if (!node) return result;
  if (!node->is_array()) complain(key, "is no list of points [[x, y, z], ...]");
  for (const toml::node& element : *node->as_array())
    result.push_back(toVec3(element, key, farthest));
  return result;
}

bool TomlTable::isList(const std::string& key) const {
  const toml::node* node = find(key);
  return node && node->is_array();
}

std::vector<std::string> TomlTable::texts(const std::string& key) const {
  std::vector<std::string> result;
  const toml::node* node = find(key);
  if (!node) return result;
  if (!node->is_array()) complain(key, "is no list of texts [\"...\", ...]");
  for (const toml::node& element : *node->as_array()) {
    if (!element.is_string()) complain(key, "is no list of texts [\"...\", ...]");
    result.push_back(toText(element, key));
  }
  return result;
}

double TomlTable::length(const std::string& key, double low, double high) const {
  const toml::node* node = find(key);
  if (!node) complain(key, "is missing; give a length as \"5mm\"");
  double value = 0;
  if (node->is_string()) {
    try {
      value = parseLength(*node->value<std::string>(), key);
    } catch (const Error& e) {
      throw error("{}: {}{}", where(node), path_, e.what());
    }
  } else if (node->is_number()) {
    value = *node->value<double>();
  } else {
    complain(key, "is no length; write it as \"5mm\"");
  }
  if (!(value >= low && value <= high))
    complain(key, fmt::format("is {}; give a length from {} to {}", lengthText(value),
                              lengthText(low), lengthText(high)));
  return value;
}

Eigen::Quaterniond TomlTable::rotation(const std::string& key) const {
  const auto t = table(key);
  if (!t) return Eigen::Quaterniond::Identity();
  if (t->has("axis")) {
    const Vec3 axis = t->vec3("axis");
    if (axis.norm() < 1e-9) complain(key, "has a zero axis");
    return rotationAbout(axis.normalized(),
                         t->number("degrees", -3600, 3600) * std::numbers::pi / 180);
  }
  const Vec3 handle = t->vec3("handle"), edge = t->vec3("edge");
  Mat3 frame;
  frame.col(2) = handle.normalized();
  frame.col(0) = (-edge).cross(frame.col(2));
  if (handle.norm() < 1e-9 || frame.col(0).norm() < 1e-6 * edge.norm() || edge.norm() < 1e-9)
    complain(key, "has a handle and an edge that do not point in different directions");
  frame.col(0).normalize();
  frame.col(1) = frame.col(2).cross(frame.col(0));
  return Eigen::Quaterniond(frame).normalized();
}

std::optional<TomlTable> TomlTable::table(const std::string& key) const {
  const toml::node* node = find(key);
  if (!node) return std::nullopt;
  if (!node->is_table()) complain(key, "is no table");
  return tables(key).front();
}

std::vector<TomlTable> TomlTable::tables(const std::string& key, std::size_t most) const {
  std::vector<TomlTable> result;
  const toml::node* node = find(key);
  if (!node) return result;
  if (const toml::table* one = node->as_table()) {
    result.push_back(TomlTable(root_, one, file_, path_ + key + "."));
    return result;
  }
  const toml::array* array = node->as_array();
  if (!array) complain(key, "is no table");
  if (array->size() > most)
    complain(key, fmt::format("is given {} times; give at most {}", array->size(), most));
  for (std::size_t i = 0; i < array->size(); ++i) {
    const toml::table* element = (*array)[i].as_table();
    if (!element) complain(key, "holds something that is no table");
    result.push_back(TomlTable(root_, element, file_, fmt::format("{}{}[{}].", path_, key, i + 1)));
  }
  return result;
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::string> names;
  for (const auto& [key, node] : *table_) names.emplace_back(key.str());
  return names;
}

void TomlTable::refuseUnknownKeys() const {
  for (const auto& [key, node] : *table_) {
    if (asked_->count(std::string(key.str()))) continue;
    std::string known;
    for (const std::string& name : *asked_) known += (known.empty() ? "" : ", ") + name;
    throw error("{}: {}{} is not known here; known are: {}", where(&node), path_,
                std::string(key.str()), known);
  }
}

}  // namespace resect
