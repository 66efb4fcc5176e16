// Saved states: restored from bytes, damage rejected, differences named.
#include <doctest/doctest.h>

#include "base/random.h"
#include "base/state/saved_state.h"
#include "base/vec.h"
#include "support/resealed.h"
#include "support/sentence.h"

using namespace resect;
using test::isOneSentence;
using test::sentenceOf;

namespace {

struct Leaf {
  std::int32_t number = 0;
  std::vector<double> values;
  std::string text;
  bool operator==(const Leaf&) const = default;

  template <class Visitor>
  void visit(Visitor& v) {
    v("number", number), v("values", values), v("text", text);
  }
};

struct Inner {
  double weight = 1;
  std::array<float, 3> triple{};
  std::array<std::vector<std::uint16_t>, 2> pair;
  std::vector<Leaf> leaves;
  bool operator==(const Inner&) const = default;

  template <class Visitor>
  void visit(Visitor& v) {
    v("weight", weight), v("triple", triple), v("pair", pair), v("leaves", leaves);
  }
};

enum class Kind : std::uint8_t { None, Some };

struct State {
  std::int64_t frame = 0;
  bool flag = false;
  Kind kind = Kind::None;
  Vec3 place = Vec3::Zero();
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  std::string name;
  std::vector<Vec3> points;
  std::vector<std::uint8_t> cells;  // 3 x 4 x 5
  Inner inner;
  std::vector<Inner> inners;
  bool operator==(const State& o) const {
    return frame == o.frame && flag == o.flag && kind == o.kind && place == o.place &&
           turn.coeffs() == o.turn.coeffs() && name == o.name && points == o.points &&
           cells == o.cells && inner == o.inner && inners == o.inners;
  }

  template <class Visitor>
  void visit(Visitor& v) {
    v("frame", frame), v("flag", flag), v("kind", kind), v("place", place), v("turn", turn);
    v("name", name), v("points", points), v.perCell("cells", cells, {0, 3, 12});
    v("inner", inner), v("inners", inners);
  }
};

Leaf leaf(int n) {
  Leaf leaf{n, {}, std::string(std::size_t(n), 'a')};
  for (int i = 0; i < n; ++i) leaf.values.push_back(0.5 * i - n);
  return leaf;
}

Inner innerOf(int n) {
  Inner inner{1.5 * n, {1.f, float(n), -2.f}, {}, {}};
  inner.pair[0].assign(std::size_t(n), std::uint16_t(n));
  inner.pair[1] = {1, 2, 3, std::uint16_t(n)};
  for (int i = 0; i < n; ++i) inner.leaves.push_back(leaf(i));
  return inner;
}

State filled() {
  State state;
  state.frame = 1234567890123;
  state.flag = true;
  state.kind = Kind::Some;
  state.place = {1, 2, 3};
  state.turn = Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Vec3::UnitY()));
  state.name = "liver";
  state.points = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  state.cells.assign(60, 1);
  state.cells[17] = 0;
  state.inner = innerOf(3);
  state.inners = {innerOf(0), innerOf(2), innerOf(4)};
  return state;
}

}  // namespace

TEST_CASE("a state comes back from its bytes into an object that held another") {
  const State state = filled();
  const Bytes bytes = toBytes(saveState(state, 42));
  for (State other : {State(), filled()}) {
    other.inners.resize(7, innerOf(5));
    other.name = "something longer";
    const SavedState saved = stateFromBytes(bytes);
    CHECK(saved.version == kStateVersion);
    CHECK(saved.fingerprint == 42);
    CHECK_FALSE(other == state);
    loadState(other, saved);
    CHECK(other == state);
    CHECK(toBytes(saveState(other, 42)) == bytes);
  }
  State empty = filled();
  loadState(empty, stateFromBytes(toBytes(saveState(State(), 0))));
  CHECK(empty == State());
}

TEST_CASE("a list of many structs comes back whole") {
  std::vector<Leaf> leaves;
  for (int i = 0; i < 1000; ++i) leaves.push_back(leaf(i % 7));
  Inner from, to;
  from.leaves = leaves;
  loadState(to, stateFromBytes(toBytes(saveState(from, 0))));
  CHECK(to.leaves == leaves);
}

TEST_CASE("bytes cut off anywhere are refused in a sentence") {
  const Bytes bytes = toBytes(saveState(filled(), 42));
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    const Bytes cut(bytes.begin(), bytes.begin() + std::ptrdiff_t(length));
    const std::string said = sentenceOf([&] { stateFromBytes(cut); });
    INFO("length ", length, ": ", said);
    CHECK(isOneSentence(said));
    CHECK(isOneSentence(sentenceOf([&] { stateFromBytes(test::resealed(cut)); })));
  }
  Bytes longer = bytes;
  longer.push_back(std::byte(0));
  CHECK(isOneSentence(sentenceOf([&] { stateFromBytes(longer); })));
}

TEST_CASE("with any bit flipped a state is refused") {
  const Bytes bytes = toBytes(saveState(filled(), 42));
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    Bytes flipped = bytes;
    flipped[bit / 8] ^= std::byte(1 << bit % 8);
    CHECK(isOneSentence(sentenceOf([&] { stateFromBytes(flipped); })));
  }
}

TEST_CASE("with a bit changed on purpose a state is refused in a sentence, or loads as another") {
  const Bytes bytes = toBytes(saveState(filled(), 42));
  int refused = 0, same = 0;
  for (std::size_t bit = 0; bit < 8 * (bytes.size() - 8); ++bit) {
    Bytes flipped = bytes;
    flipped[bit / 8] ^= std::byte(1 << bit % 8);
    flipped = test::resealed(flipped);
    State other;
    std::uint64_t fingerprint = 42;
    std::uint32_t version = kStateVersion;
    const std::string said = sentenceOf([&] {
      const SavedState saved = stateFromBytes(flipped);
      fingerprint = saved.fingerprint;
      version = saved.version;
      loadState(other, saved);
    });
    INFO("bit ", bit, ": ", said);
    refused += !said.empty();
    if (!said.empty()) {
      CHECK(isOneSentence(said));
      continue;
    }
    // Nothing but the numbers can be wrong then.
    same += toBytes(saveState(other, fingerprint)) == bytes && version == kStateVersion;
    CHECK(other.inners.size() < 100);
    CHECK(other.name.size() < 100);
    // What was loaded is a state like another: a bool is one of two.
    State again;
    loadState(again, saveState(other, 0));
    CHECK(toBytes(saveState(again, 0)) == toBytes(saveState(other, 0)));
  }
  MESSAGE(refused, " of ", 8 * bytes.size(), " refused");
  CHECK(refused > int(bytes.size()));
  CHECK(same < 32);  // 7 bits of the byte of `flag`; a word by itself or as a run of one
}

TEST_CASE("a count of entries beyond what is there is refused before memory is taken") {
  SavedState saved = saveState(filled(), 0);
  for (StateColumn& field : saved.root.fields)
    if (field.name == "inners") field.counts[0] = 4;
  State state;
  const std::string said = sentenceOf([&] { loadState(state, saved); });
  CHECK(isOneSentence(said));
  CHECK(said.find("\"inners\"") != std::string::npos);
  CHECK(state.inners.empty());
}

namespace {

// `State` as another version of the program has it.
struct OtherState {
  std::int64_t frame = 0;
  std::string name;
  std::vector<double> more{1, 2};
  Inner extra = innerOf(2);

  template <class Visitor>
  void visit(Visitor& v) {
    v("name", name), v("frame", frame), v("more", more), v("extra", extra);
  }
};
struct OlderState {
  std::int64_t frame = 7;
  std::string name = "older";

  template <class Visitor>
  void visit(Visitor& v) {
    v("frame", frame), v("name", name);
  }
};

}  // namespace

TEST_CASE("of an older version what is missing keeps its value, of the same it is named") {
  SavedState saved = stateFromBytes(toBytes(saveState(OlderState(), 0)));
  OtherState state;
  const std::string said = sentenceOf([&] { loadState(state, saved); });
  CHECK(isOneSentence(said));
  CHECK(said.find("\"more\"") != std::string::npos);

  saved.version = kStateVersion - 1;
  OtherState older;
  loadState(older, stateFromBytes(toBytes(saved)));
  CHECK(older.frame == 7);
  CHECK(older.name == "older");
  CHECK(older.more == std::vector<double>{1, 2});
  CHECK(older.extra == innerOf(2));
}

TEST_CASE("a missing field is named by its path within lists of structs") {
  SavedState saved = saveState(filled(), 0);
  for (StateColumn& field : saved.root.fields)
    if (field.name == "inners")
      for (StateColumn& inner : field.fields)
        if (inner.name == "leaves")
          std::erase_if(inner.fields, [](const StateColumn& c) { return c.name == "text"; });
  State state;
  CHECK(sentenceOf([&] { loadState(state, saved); }).find("\"inners.leaves.text\"") !=
        std::string::npos);
  saved.version = kStateVersion - 1;
  loadState(state, saved);
  CHECK(state.inners[2].leaves[3].values == filled().inners[2].leaves[3].values);
  CHECK(state.inners[2].leaves[3].text.empty());
}

TEST_CASE("a field that nobody knows is refused and named, of an older version too") {
  SavedState saved = saveState(OtherState(), 0);
  for (const std::uint32_t version : {kStateVersion, kStateVersion - 1}) {
    saved.version = version;
    OlderState state;
    const std::string said = sentenceOf([&] { loadState(state, saved); });
    CHECK(isOneSentence(said));
    CHECK(said.find("\"more\"") != std::string::npos);
  }
}

TEST_CASE("a field of other numbers or another length is refused and named") {
  const auto saidOf = [](const char* name, auto change) {
    SavedState saved = saveState(filled(), 0);
    for (StateColumn& field : saved.root.fields)
      if (field.name == name) change(field);
    State state;
    return sentenceOf([&] { loadState(state, saved); });
  };
  const std::vector<std::string> said{
      saidOf("place", [](StateColumn& c) { c.size = 4; }),
      saidOf("place", [](StateColumn& c) { c.data.pop_back(); }),
      saidOf("place", [](StateColumn& c) { c.data.resize(32); }),
      saidOf("place", [](StateColumn& c) { c.isList = true, c.counts = {3}; }),
  };
  for (const std::string& s : said) {
    CHECK(isOneSentence(s));
    CHECK(s.find("\"place\"") != std::string::npos);
  }
  for (const std::string& s :
       {saidOf("points", [](StateColumn& c) { c.isList = false, c.counts.clear(); }),
        saidOf("points", [](StateColumn& c) { c.counts.push_back(0); }),
        saidOf("points", [](StateColumn& c) { c.counts[0] = 2; }),
        saidOf("points", [](StateColumn& c) { c.counts[0] = 4; })}) {
    CHECK(isOneSentence(s));
    CHECK(s.find("\"points\"") != std::string::npos);
  }
}

TEST_CASE("the first difference names the field of whatever bit is flipped, and its cell") {
  const SavedState saved = saveState(filled(), 42);
  CHECK_FALSE(firstDifference(saved, saved));
  CHECK_FALSE(firstDifference(saved, stateFromBytes(toBytes(saved))));
  Random random(3);
  int fields = 0;
  const auto visit = [&](const auto& self, const StateColumn& column, SavedState& other,
                         StateColumn& otherColumn, const std::string& path) -> void {
    if (!column.data.empty()) {
      ++fields;
      const std::size_t byte = std::size_t(random.below(int(column.data.size())));
      otherColumn.data[byte] ^= std::byte(1 << random.below(8));
      const std::size_t number = byte / column.size;
      const std::string expected =
          path == "cells"
              ? fmt::format("cells, cell ({}, {}, {})", number % 3, number / 3 % 4, number / 12)
              : fmt::format("{}, number {}", path, number);
      CHECK(firstDifference(saved, other).value_or("") == expected);
      CHECK(firstDifference(stateFromBytes(toBytes(other)), saved).value_or("") == expected);
      otherColumn.data = column.data;
    }
    for (std::size_t i = 0; i < column.fields.size(); ++i)
      self(self, column.fields[i], other, otherColumn.fields[i],
           (path.empty() ? "" : path + ".") + column.fields[i].name);
  };
  SavedState other = saved;
  visit(visit, saved.root, other, other.root, "");
  CHECK(fields == 22);
  CHECK(other.root.data == saved.root.data);

  State longer = filled();
  longer.inners[1].leaves[1].values.push_back(1);
  CHECK(firstDifference(saved, saveState(longer, 42)) == "inners.leaves.values, its length");
  CHECK(firstDifference(saved, saveState(filled(), 43)) == "what they are states of");
}

namespace {

// Two lists of cells of lattices that are not the same, several numbers a cell.
struct Lattices {
  struct One {
    std::vector<Vec3> u;
    CellOrder order;
    template <class Visitor>
    void visit(Visitor& v) {
      v.perCell("u", u, order);
    }
  };
  std::vector<One> organs{{std::vector<Vec3>(24, Vec3::Zero()), {0, 2, 6}},
                          {std::vector<Vec3>(40, Vec3::Zero()), {4, 3, 12}}};
  template <class Visitor>
  void visit(Visitor& v) {
    v.fixed("organs", organs);
  }
};

}  // namespace

TEST_CASE("a difference is told by the cell of its own lattice, margins and all") {
  const Lattices a;
  Lattices b;
  b.organs[1].u[4 + 2 + 3 * 1 + 12 * 2].y() = 1;
  CHECK(firstDifference(saveState(a, 0), saveState(b, 0)) == "organs.u, list 1, cell (2, 1, 2)");
  b.organs[0].u[1 + 2 * 2 + 6 * 3].z() = 1;
  CHECK(firstDifference(saveState(a, 0), saveState(b, 0)) == "organs.u, list 0, cell (1, 2, 3)");
}

TEST_CASE("a list that has its length for good refuses a state with another one") {
  Lattices three;
  three.organs.push_back(three.organs[0]);
  Lattices two;
  const std::string said = sentenceOf([&] { loadState(two, saveState(three, 0)); });
  CHECK(isOneSentence(said));
  CHECK(said.find("organs") != std::string::npos);
}

TEST_CASE("the digest depends on each number and on how a state is divided into lists") {
  const auto hash = [](const State& state) {
    HashVisitor visitor;
    visitState(state, visitor);
    return visitor.value();
  };
  State state = filled();
  const std::uint64_t first = hash(state);
  CHECK(first == hash(filled()));
  std::swap(state.inners[1].pair[0], state.inners[1].pair[1]);
  CHECK(hash(state) != first);
  state = filled();
  state.inners[2].leaves[2].values.push_back(0);
  CHECK(hash(state) != first);
  state = filled();
  state.flag = false;
  CHECK(hash(state) != first);
}
