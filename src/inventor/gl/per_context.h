// What does a node keep in each graphics context, and how is it given back to OpenGL?
//
// OpenGL's objects may be deleted only while their context is current. So each context's are freed
// when Coin says that it is about to be destroyed, and, when the node goes first, when Coin says
// that the context is current again.
#pragma once

#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/misc/SoContextHandler.h>

#include <cstdint>
#include <map>
#include <memory>

namespace resect {

// Kept::free() deletes its OpenGL objects; it is called with their context current. Kept may be
// incomplete where a PerContext is declared, not where one is made, used or destroyed.
template <typename Kept>
class PerContext {
 public:
  PerContext() { SoContextHandler::addContextDestructionCallback(destroyed, this); }
  ~PerContext() {
    SoContextHandler::removeContextDestructionCallback(destroyed, this);
    for (auto& [context, kept] : contexts_)
      SoGLCacheContextElement::scheduleDeleteCallback(
          context,
          [](void* closure, std::uint32_t) {
            const std::unique_ptr<Kept> dead(static_cast<Kept*>(closure));
            dead->free();
          },
          kept.release());
  }
  PerContext(const PerContext&) = delete;
  PerContext& operator=(const PerContext&) = delete;

  // Made at the first call for this context.
  Kept& operator[](std::uint32_t context) {
    std::unique_ptr<Kept>& kept = contexts_[context];
    if (!kept) kept = std::make_unique<Kept>();
    return *kept;
  }

  // Pairs of a context and a pointer to what is kept in it.
  auto begin() { return contexts_.begin(); }
  auto end() { return contexts_.end(); }

 private:
  static void destroyed(std::uint32_t context, void* closure) {
    auto& contexts = static_cast<PerContext*>(closure)->contexts_;
    const auto found = contexts.find(context);
    if (found == contexts.end()) return;
    found->second->free();
    contexts.erase(found);
  }

  std::map<std::uint32_t, std::unique_ptr<Kept>> contexts_;
};

}  // namespace resect
