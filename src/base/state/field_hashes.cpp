#include "base/state/field_hashes.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace resect {
namespace {

constexpr std::uint64_t kFactor = 0x9fb21c651e98df25u;  // odd, so that multiplying loses nothing

std::uint64_t mixed(std::uint64_t z) {  // finaliser of splitmix64 (Steele, Lea, Flood 2014)
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

}  // namespace

std::uint64_t fastHash(const void* data, std::size_t bytes, std::uint64_t start) {
  const auto* p = static_cast<const unsigned char*>(data);
  std::uint64_t lane[4] = {start ^ bytes, start + 1, start + 2, start + 3};
  for (; bytes >= 32; p += 32, bytes -= 32) {
    std::uint64_t word[4];
    std::memcpy(word, p, 32);
    for (int i = 0; i < 4; ++i) {
      lane[i] = (lane[i] ^ word[i]) * kFactor;
      lane[i] ^= lane[i] >> 29;
    }
  }
  std::uint64_t rest[4] = {};
  std::memcpy(rest, p, bytes);
  std::uint64_t hash = 0;
  for (int i = 0; i < 4; ++i) hash = mixed(hash * kFactor + mixed((lane[i] ^ rest[i]) * kFactor));
  return hash;
}

FieldHashes::FieldHashes(std::vector<std::string> paths)
    : paths_(std::move(paths)), values_(paths_.size(), 0) {
  seal();
}

void FieldHashes::seal() {
  sealed_ = true;
  leaf_.assign(paths_.size(), 1);
  for (std::size_t i = 0; i < paths_.size(); ++i)
    for (const std::string& other : paths_)
      if (other.starts_with(paths_[i] + ".")) leaf_[i] = 0;
}

void FieldHashes::clear() {
  std::ranges::fill(values_, 0);
  next_ = 0;
}

std::uint64_t& FieldHashes::at(const char* name) {
  const std::size_t length = path_.size();
  if (*name) (path_ += path_.empty() ? "" : ".") += name;
  // Visits repeat their order, so the field is most often the next one.
  if (next_ >= paths_.size() || paths_[next_] != path_) {
    next_ = std::size_t(std::ranges::find(paths_, path_) - paths_.begin());
    if (next_ == paths_.size() && sealed_) {
      strange_ = true;
      path_.resize(length);
      return ignored_;
    }
    if (next_ == paths_.size()) {
      paths_.push_back(path_);
      values_.push_back(0);
    }
  }
  path_.resize(length);
  return values_[next_++];
}

void FieldHashes::numbers(const char* name, void* data, std::size_t count, std::size_t size) {
  std::uint64_t& value = inField_ > 0 ? values_[field_] : at(name);
  value = fastHash(data, count * size, value);
}

std::size_t FieldHashes::enterList(const char* name, std::size_t count) {
  enter(name);
  const bool within = inField_ > 0;
  std::uint64_t& value = within ? values_[field_] : at("");
  value = mixed(value ^ count) * kFactor;
  if (within || !sealed_ || &value == &ignored_) return count;
  const auto number = std::size_t(&value - values_.data());
  if (leaf_[number]) field_ = number, inField_ = 1;
  return count;
}

void FieldHashes::enter(const char* name) {
  if (inField_ > 0) {
    ++inField_;
    return;
  }
  lengths_.push_back(path_.size());
  if (*name) (path_ += path_.empty() ? "" : ".") += name;
}

void FieldHashes::leave() {
  if (inField_ > 0 && --inField_ > 0) return;
  path_.resize(lengths_.back());
  lengths_.pop_back();
}

}  // namespace resect
