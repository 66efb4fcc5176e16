// OpenGL objects of a scene node, kept and freed per graphics context.
//
// OpenGL's objects may be deleted only while their context is current. So the objects of a context
// are freed when Coin announces that the context will be destroyed, or, if the node is destroyed
// first, when the context is next current.
#pragma once

#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/misc/SoContextHandler.h>

#include <cstdint>
#include <map>
#include <memory>

namespace resect {

// Kept: a struct of one context's OpenGL objects. Kept::free() deletes its OpenGL objects; it is
// called with their context current. Kept may be incomplete where a PerContext is declared, but not
// where one is constructed, used or destroyed.
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

  // Pairs of a context and a pointer to its objects.
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
