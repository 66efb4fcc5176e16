// Holds the OpenGL objects of a scene node, separately for each graphics context, and frees them.
//
// OpenGL objects may be deleted only while their context is current. So the objects are freed when
// Coin announces that their context will be destroyed. If the node is destroyed first, they are
// freed the next time that their context is current.
#pragma once

#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/misc/SoContextHandler.h>

#include <cstdint>
#include <map>
#include <memory>

namespace resect {

// Kept: a struct that holds the OpenGL objects of one context. Its member function free() deletes
// them; it is called while their context is current. Kept may be an incomplete type where a
// PerContext is declared as a member, but not where one is constructed, used or destroyed.
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

  // The objects of this context. They are made at the first call for the context.
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
