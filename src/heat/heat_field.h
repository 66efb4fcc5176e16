// The temperature of tissue round the places that were heated, and how far the tissue there is
// coagulated, dried out and charred.
//
// The bioheat equation (Pennes 1948) is solved for the tissue at rest, on a lattice that does not
// depend on the size of the organ's cells (T in degrees Celsius, written C below; source: heat
// brought in, W/m^3; coagulated: share, 0 to 1; the other symbols are named at the constants
// below):
//
//     rho c dT/dt = k laplacian(T) - w rho_b c_b (1 - coagulated) (T - 37) + source
//
// Water boils at 100 C: as long as any is left, further heat makes steam and does not raise the
// temperature. Coagulation is a first-order reaction. Its rate follows Eyring's law, with the
// enthalpy and entropy that Jacques, Newman and He (1991) measured on pig liver. Dry tissue chars
// above 150 C.
//
// A cell of this lattice is stored (as HeatedSpot) while it is warm (at least 0.01 K above 37 C),
// is beside a warm cell, or its tissue has changed by heat. Elsewhere the tissue is at 37 C and
// unchanged. No heat flows through the tissue's surface. Single vessels do not cool the tissue; the
// perfusion w stands for all of them.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "sph/lattice.h"

namespace resect {

// Properties of liver after Duck 1990; the perfusion after Ebbini et al. 1988: 0.38 ml of blood per
// ml of tissue and minute.
inline constexpr double kBodyTemperature = 37;         // C
inline constexpr double kConductivity = 0.52;          // k, W/(m K)
inline constexpr double kHeatCapacity = 1060 * 3600;   // rho c, J/(m^3 K)
inline constexpr double kPerfusion = 6.4e-3;           // w, 1/s
inline constexpr double kBloodCapacity = 1060 * 3640;  // rho_b c_b, J/(m^3 K)

// Rate of the coagulation reaction at a temperature in C, 1/s.
double coagulationRate(double temperature);

// A cell of the heat lattice.
struct HeatedSpot {
  std::int64_t index = -1;                // in HeatField::lattice()
  double temperature = kBodyTemperature;  // C
  double water = 1;                       // share of the cell's water that is left, 0 to 1
  double coagulated = 0, charred = 0;     // shares, 0 to 1

  template <class Visitor>
  void visit(Visitor& v) {
    v("index", index), v("temperature", temperature), v("water", water);
    v("coagulated", coagulated), v("charred", charred);
  }
};

// Heat that is brought into a ball of tissue during a frame.
struct HeatSource {
  Vec3 place = Vec3::Zero();  // centre of the ball, in rest space, m
  double radius = 0;          // of the ball, m
  double power = 0;           // W
};

class HeatField {
 public:
  static constexpr double kSpacing = 0.0015;  // spacing of the heat lattice, m

  HeatField() = default;
  // box: the bounding box of the organ at rest, m.
  explicit HeatField(const Aabb& box);

  // Computes a frame. duration: of the frame, s. isTissue: whether there is tissue at a point,
  // given in the coordinates of the organ at rest (rest space). Cost: proportional to the number of
  // spots; nothing if no spot is warm and there is no source.
  void step(std::span<const HeatSource> sources, double duration,
            const std::function<bool(const Vec3&)>& isTissue);

  // Drops the spots at which there is no tissue any more.
  void keepIn(const std::function<bool(const Vec3&)>& isTissue);

  // Values at a point in rest space, interpolated between the 8 nearest lattice points.
  double temperature(const Vec3& place) const;
  double coagulated(const Vec3& place) const;
  double charred(const Vec3& place) const;

  const Lattice& lattice() const { return lattice_; }
  std::span<const HeatedSpot> spots() const { return spots_; }  // by ascending index
  bool empty() const { return spots_.empty(); }
  // Whether the coagulated or charred share of any spot has grown in the last step().
  bool changed() const { return changed_; }
  // Water that became steam in the last step(), kg.
  double steam() const { return steam_; }
  // The heat that all spots hold beyond 37 C, and the latent heat of the water that has become
  // steam, J.
  double energy() const;

  template <class Visitor>
  void visit(Visitor& v) {
    v("spots", spots_);
  }
  template <class Visitor>
  void visitMade(Visitor& v) {
    v.made(lattice_, changed_, steam_, added_, flux_);
  }
  // Throws Error unless the loaded spots are cells of the lattice, in ascending order, with finite
  // temperatures.
  void requireSound() const;

 private:
  const HeatedSpot* find(std::int64_t index) const;
  template <typename Value>
  double between(const Vec3& place, double elsewhere, Value value) const;
  void add(const HeatSource& source, double duration,
           const std::function<bool(const Vec3&)>& isTissue);
  void spread(const std::function<bool(const Vec3&)>& isTissue);
  void conduct(double duration);
  void insert();
  void forget();

  std::vector<HeatedSpot> spots_;
  Lattice lattice_;
  bool changed_ = false;
  double steam_ = 0;
  std::vector<std::int64_t> added_;  // temporary, of step()
  std::vector<double> flux_;         // temporary, of step(): heat flow into each spot, W
};

}  // namespace resect
