// Visitors that save, load, hash and measure a state. Every struct that holds state names its
// fields once, in
//
//     template <class Visitor> void visit(Visitor& v) { v("time", time); v("poses", poses); ... }
//
// Every operation on all fields is a StateVisitor: computing the digest (HashVisitor), saving and
// loading (base/state/saved_state.h), counting the memory held (HeldBytes). Two sorts of fields are
// not state: derived data, and fields that never change after they were set up. visitMade() names
// these fields, by v.made(field, another, ...), so that their memory is counted. A test finds
// fields that neither visit() nor visitMade() names.
//
// A field may be:
//
//   - a number, an enum, a fixed-size Eigen matrix, an Eigen::Quaterniond or a string;
//   - a struct with visit();
//   - an array of numbers, enums or matrices;
//   - an array of other types of this list, with at most 9 entries;
//   - a vector of numbers, of enums, of matrices, of arrays of numbers, or of structs;
//   - a std::optional, which counts as a list of at most one entry.
//
// Names are string literals. visitState() passes the fields of const objects, so a visitor that is
// used with visitState() must not write to the fields.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <type_traits>

#include "base/state/state_hash.h"

namespace resect {

// Layout of an array with an entry per cell. Cell (x, y, z) has the index front + x + strideY * y +
// strideZ * z. With this layout a difference between two states can be reported by cell.
struct CellOrder {
  std::int64_t front = 0, strideY = 0, strideZ = 0;
};

[[noreturn]] void throwOtherCount(const char* name, std::size_t here);

namespace state_detail {

template <typename T>
concept Number = std::is_arithmetic_v<T> || std::is_enum_v<T>;
template <typename T>
concept FixedMatrix = requires {
  T::SizeAtCompileTime;
}
&&(T::SizeAtCompileTime > 0);
template <typename T>
concept Turn = std::is_same_v<T, Eigen::Quaterniond>;
// Numbers of one type, contiguous in memory.
template <typename T>
concept Plain = Number<T> || FixedMatrix<T>;
template <typename T>
struct PlainOf {
  using Scalar = T;
  static constexpr std::size_t count = 1;
};
template <FixedMatrix T>
struct PlainOf<T> {
  using Scalar = typename T::Scalar;
  static constexpr std::size_t count = T::SizeAtCompileTime;
};
template <typename T>
struct IsArray : std::false_type {};
template <typename T, std::size_t N>
struct IsArray<std::array<T, N>> : std::true_type {};
template <typename T>
struct IsOptional : std::false_type {};
template <typename T>
struct IsOptional<std::optional<T>> : std::true_type {};
template <typename T, std::size_t N>
requires(Number<T> && !std::is_same_v<T, bool>) struct PlainOf<std::array<T, N>> {
  using Scalar = T;
  static constexpr std::size_t count = N;
};
template <typename T>
concept NumberArray = IsArray<T>::value && requires {
  typename PlainOf<T>::Scalar;
} && !std::is_same_v<typename PlainOf<T>::Scalar, T>;
template <typename T>
concept List = requires(T& t) {
  t.data();
  t.resize(std::size_t());
  t.capacity();
};

inline constexpr const char* kIndexName[] = {"0", "1", "2", "3", "4", "5", "6", "7", "8"};

}  // namespace state_detail

class StateVisitor {
 public:
  virtual ~StateVisitor() = default;

  template <typename T>
  void operator()(const char* name, T& field) {
    using namespace state_detail;
    object(&field, sizeof field);
    if constexpr (Plain<T>) {
      numbers(name, address(field), PlainOf<T>::count, sizeof(typename PlainOf<T>::Scalar));
      if constexpr (std::is_same_v<T, bool>) makeBool(field);
    } else if constexpr (Turn<T>) {
      numbers(name, field.coeffs().data(), 4, sizeof(double));
    } else if constexpr (IsArray<T>::value) {
      array(name, field);
    } else if constexpr (List<T>) {
      list(name, field);
    } else if constexpr (IsOptional<T>::value) {
      optional(name, field);
    } else {
      enter(name);
      field.visit(*this);
      leave();
    }
  }
  // Names fields that are not state.
  template <typename... T>
  void made(T&... fields) {
    (madeOne(fields), ...);
  }
  // For a list of structs whose length never changes. Throws Error if the list has another length
  // in the state that is loaded.
  template <typename T>
  void fixed(const char* name, T& field) {
    object(&field, sizeof field);
    memory(field.capacity() * sizeof(typename T::value_type));
    if (enterList(name, field.size()) != field.size()) throwOtherCount(name, field.size());
    for (auto& element : field) element.visit(*this);
    leave();
  }
  // For a list with an entry per cell.
  template <typename T>
  void perCell(const char* name, T& field, const CellOrder& order) {
    order_ = &order;
    (*this)(name, field);
    order_ = nullptr;
  }

 protected:
  // Called for each field, with its address and size, before its contents are visited.
  virtual void object(const void*, std::size_t) {}
  // Called with the heap memory that a field holds, bytes.
  virtual void memory(std::size_t) {}
  // `count` numbers of `size` bytes each.
  virtual void numbers(const char* name, void* data, std::size_t count, std::size_t size) = 0;
  // Called when a list of `count` entries begins. Returns the number of entries that the list must
  // have. Only a visitor that loads may return another number than `count`. After this call the
  // entries are visited. Numbers and matrices come in one call of numbers() with an empty name.
  // Structs come one after the other, and each struct comes field by field. A call of leave() ends
  // the list.
  virtual std::size_t enterList(const char* name, std::size_t count) = 0;
  virtual void enter(const char* name) = 0;
  virtual void leave() = 0;
  const CellOrder* order() const { return order_; }

 private:
  template <typename T>
  void madeOne(T& field) {
    object(&field, sizeof field);
    madeMemory(field);
  }
  template <typename T>
  void madeMemory(T& field) {
    using namespace state_detail;
    if constexpr (requires { field.bytes(); })
      memory(field.bytes());
    else if constexpr (List<T>)
      memory(field.capacity() * sizeof(typename T::value_type));
    else if constexpr (IsArray<T>::value)
      for (auto& element : field) madeMemory(element);
  }
  // If the loaded byte of a bool is neither 0 nor 1, sets the bool to true. Otherwise writes
  // nothing.
  static void makeBool(bool& field) {
    unsigned char byte = 0;
    std::memcpy(&byte, &field, 1);
    if (byte > 1) field = true;
  }
  template <typename T>
  static void* address(T& field) {
    if constexpr (state_detail::FixedMatrix<T>)
      return field.data();
    else
      return &field;
  }
  template <typename T>
  void array(const char* name, T& field) {
    using namespace state_detail;
    using Element = typename T::value_type;
    if constexpr (Plain<Element>) {
      numbers(name, field.data(), field.size() * PlainOf<Element>::count,
              sizeof(typename PlainOf<Element>::Scalar));
      if constexpr (std::is_same_v<Element, bool>)
        for (bool& element : field) makeBool(element);
    } else {
      static_assert(std::tuple_size_v<T> <= std::size(kIndexName));
      enter(name);
      for (std::size_t i = 0; i < field.size(); ++i) (*this)(kIndexName[i], field[i]);
      leave();
    }
  }
  template <typename T>
  void list(const char* name, T& field) {
    using namespace state_detail;
    using Element = typename T::value_type;
    memory(field.capacity() * sizeof(Element));
    const std::size_t count = enterList(name, field.size());
    if constexpr (Plain<Element> || NumberArray<Element>) {
      if (count != field.size()) field.resize(count);
      numbers("", field.data(), count * PlainOf<Element>::count,
              sizeof(typename PlainOf<Element>::Scalar));
    } else {
      // While a list is loaded, it grows step by step. So a damaged state that gives too large a
      // count does not cause the allocation of memory for all these entries.
      if (count < field.size()) field.resize(count);
      for (std::size_t i = 0; i < count; ++i) {
        if (i == field.size()) field.resize(std::min(count, i + std::max(i, std::size_t(64))));
        field[i].visit(*this);
      }
    }
    leave();
  }

  template <typename T>
  void optional(const char* name, T& field) {
    using namespace state_detail;
    using Value = typename T::value_type;
    const bool has = enterList(name, field ? 1 : 0) > 0;
    if (has && !field) field.emplace();
    if (!has && field) field.reset();
    if constexpr (Plain<Value>) {
      using Scalar = typename PlainOf<Value>::Scalar;
      numbers("", has ? address(*field) : nullptr, has ? PlainOf<Value>::count : 0, sizeof(Scalar));
    } else if (has) {
      (*this)("value", *field);
    }
    leave();
  }

  const CellOrder* order_ = nullptr;
};

// For visitors that only read.
template <typename State>
void visitState(const State& state, StateVisitor& reader) {
  const_cast<State&>(state).visit(reader);
}

// Digest of all fields. It depends on their values and order, not on their names.
class HashVisitor final : public StateVisitor {
 public:
  std::uint64_t value() const { return hash_.value(); }

 protected:
  void numbers(const char*, void* data, std::size_t count, std::size_t size) override {
    hash_.addBytes(data, count * size);
  }
  std::size_t enterList(const char*, std::size_t count) override {
    hash_.add(std::uint64_t(count));
    return count;
  }
  void enter(const char*) override {}
  void leave() override {}

 private:
  StateHash hash_;
};

// Heap memory of all fields, bytes. The memory of a list is computed from the list's capacity. If a
// field that is not state has a function bytes(), the result of this function is its memory.
class HeldBytes final : public StateVisitor {
 public:
  std::size_t value() const { return bytes_; }

 protected:
  void memory(std::size_t bytes) override { bytes_ += bytes; }
  void numbers(const char*, void*, std::size_t, std::size_t) override {}
  std::size_t enterList(const char*, std::size_t count) override { return count; }
  void enter(const char*) override {}
  void leave() override {}

 private:
  std::size_t bytes_ = 0;
};

// Heap memory, bytes, of a state with visit() and visitMade().
template <typename State>
std::size_t heldBytes(const State& state) {
  HeldBytes held;
  const_cast<State&>(state).visit(held);
  const_cast<State&>(state).visitMade(held);
  return held.value();
}

}  // namespace resect
