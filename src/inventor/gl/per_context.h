// Holds the OpenGL objects of a scene node, separately for each graphics context, and frees these
// objects.
//
// OpenGL objects may be deleted only while their context is current. So the objects are freed when
// Coin announces that their context will be destroyed. If the node is destroyed before the context,
// the objects are freed the next time that the context is current.
#pragma once

#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/misc/SoContextHandler.h>

#include <cstdint>
#include <map>
#include <memory>

namespace resect {

// Kept: a struct that holds the OpenGL objects of one context. It must have a member function
// free(), which deletes these objects. PerContext calls free() while the context is current. Where
// a PerContext is only declared as a member, Kept may be an incomplete type. Where a PerContext is
// constructed, used or destroyed, Kept must be complete.
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

  // The objects of a context. The first call for a context makes them.
  Kept& operator[](std::uint32_t context) {
    std::unique_ptr<Kept>& kept = contexts_[context];
    if (!kept) kept = std::make_unique<Kept>();
    return *kept;
  }

  // Iterators over pairs: the context, and a pointer to its objects.
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
