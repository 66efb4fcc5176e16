// Inventor node that tells shaders where blood lies on the table. The shaders are those of the
// nodes that come after this node, such as data/shaders/cloth.frag. In an .iv file,
// `BloodPool {}` makes a node without blood.
#pragma once

#include <Inventor/fields/SoSFInt32.h>
#include <Inventor/nodes/SoNode.h>
#include <Inventor/nodes/SoSubNode.h>

#include <cstdint>
#include <vector>

#include "inventor/gl/per_context.h"

namespace resect {

inline constexpr int kPoolUnit = 2;  // texture unit of the blood's depths

class SoBloodPool : public SoNode {
  SO_NODE_HEADER(SoBloodPool);

 public:
  static void initClass();
  SoBloodPool();

  SoSFInt32 revision;  // number of changes so far; set() updates it

  // Sets the depths of the blood on a square of 1 m x 1 m, whose middle is the origin. depths: n *
  // n bytes, x fastest. The value 255 stands for 5 mm. If `depths` is empty, there is no blood.
  void set(std::vector<std::uint8_t> depths);

 protected:
  ~SoBloodPool() override;
  void GLRender(SoGLRenderAction* action) override;

 private:
  struct ContextTexture;
  std::vector<std::uint8_t> depths_;
  PerContext<ContextTexture> contexts_;
};

}  // namespace resect
