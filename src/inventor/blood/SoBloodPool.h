// Inventor node that passes the blood on the table to the shaders of the nodes after it
// (data/shaders/cloth.frag). In .iv files: `BloodPool {}`, which has no blood.
#pragma once

#include <Inventor/fields/SoSFInt32.h>
#include <Inventor/nodes/SoNode.h>
#include <Inventor/nodes/SoSubNode.h>

#include <cstdint>
#include <vector>

#include "inventor/gl/per_context.h"

namespace resect {

inline constexpr int kPoolUnit = 2;  // texture unit

class SoBloodPool : public SoNode {
  SO_NODE_HEADER(SoBloodPool);

 public:
  static void initClass();
  SoBloodPool();

  SoSFInt32 revision;  // number of changes so far; set() writes it

  // Sets the depths of the blood on a square of 1 m round the origin: n * n bytes, x fastest; 255
  // stands for 5 mm. Empty: no blood.
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
