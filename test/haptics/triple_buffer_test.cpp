// The reader of a triple buffer sees whole values, in order, and the last one.
#include "haptics/triple_buffer.h"

#include <doctest/doctest.h>

#include <thread>

using namespace resect;

namespace {

// Far larger than what a machine writes at once.
struct Value {
  std::array<std::int64_t, 64> numbers{};
};

Value valueOf(std::int64_t number) {
  Value value;
  value.numbers.fill(number);
  return value;
}

}  // namespace

TEST_CASE("a triple buffer gives the newest value, once") {
  TripleBuffer<int> buffer;
  CHECK(!buffer.update());
  CHECK(buffer.newest() == 0);
  for (const int value : {1, 2, 3}) buffer.publish(value);
  CHECK(buffer.update());
  CHECK(buffer.newest() == 3);
  CHECK(!buffer.update());
  CHECK(buffer.newest() == 3);
  buffer.draft() = 4;
  CHECK(!buffer.update());
  buffer.publish();
  CHECK(buffer.update());
  CHECK(buffer.newest() == 4);
}

TEST_CASE("the reader of a triple buffer sees whole values in order, however fast they come") {
  constexpr std::int64_t kCount = 200000;
  TripleBuffer<Value> buffer;
  std::thread writer([&] {
    for (std::int64_t i = 1; i <= kCount; ++i) {
      buffer.draft().numbers.fill(i);
      buffer.publish();
      if (i % 1024 == 0) std::this_thread::yield();
    }
  });
  std::int64_t last = 0, updates = 0, torn = 0, backwards = 0;
  while (last < kCount) {
    if (!buffer.update()) {
      std::this_thread::yield();
      continue;
    }
    const Value& value = buffer.newest();
    const std::int64_t first = value.numbers.front();
    torn += value.numbers != valueOf(first).numbers;
    backwards += first <= last;
    last = first;
    ++updates;
  }
  writer.join();
  CHECK(torn == 0);
  CHECK(backwards == 0);
  CHECK(updates > 0);
  CHECK(last == kCount);
}
