// The temperature of tissue round heated places, and the fractions of this tissue that are
// coagulated, dried out and charred.
//
// Temperatures are stored on a lattice in rest space, the coordinates of the undeformed organ. This
// lattice does not depend on the size of the organ's cells. The bioheat equation (Pennes 1948) is
// solved on this lattice:
//
//     rho c dT/dt = k laplacian(T) - w rho_b c_b (1 - coagulated) (T - 37) + source
//
// T is the temperature in degrees Celsius, which this header writes as C. `source` is the heating
// power per volume, W/m^3. `coagulated` is the coagulated fraction of the tissue, 0 to 1. The
// comments at the constants below explain the other symbols.
//
// Water boils at 100 C. As long as a cell contains water, more heat turns this water into steam and
// does not raise the temperature. Coagulation is a first-order reaction. Its rate follows Eyring's
// law, with the enthalpy and entropy that Jacques, Newman and He (1991) measured in pig liver. Dry
// tissue chars above 150 C.
//
// A stored cell of this lattice is called a spot (HeatedSpot). A cell is stored if it is warm (at
// least 0.01 K above 37 C), if it is beside a warm cell, or if heat has changed its tissue. In all
// other cells the tissue is at 37 C and unchanged. No heat flows through the tissue's surface. The
// perfusion w stands for the cooling by all vessels together. No vessel is considered singly.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "sph/lattice.h"

namespace resect {

// Body temperature, and properties of liver and blood. The perfusion is from Ebbini et al. 1988:
// 0.38 ml of blood per minute and ml of tissue. The other properties are from Duck 1990.
inline constexpr double kBodyTemperature = 37;         // C
inline constexpr double kConductivity = 0.52;          // k, W/(m K)
inline constexpr double kHeatCapacity = 1060 * 3600;   // rho c of tissue, J/(m^3 K)
inline constexpr double kPerfusion = 6.4e-3;           // w, 1/s
inline constexpr double kBloodCapacity = 1060 * 3640;  // rho_b c_b of blood, J/(m^3 K)

// Rate of the coagulation reaction, 1/s. temperature: C.
double coagulationRate(double temperature);

// A cell of the heat lattice whose values are stored.
struct HeatedSpot {
  std::int64_t index = -1;                // index of the cell in HeatField::lattice()
  double temperature = kBodyTemperature;  // C
  double water = 1;                       // fraction of the cell's water that is left, 0 to 1
  double coagulated = 0, charred = 0;     // fractions of the cell's tissue, 0 to 1

  template <class Visitor>
  void visit(Visitor& v) {
    v("index", index), v("temperature", temperature), v("water", water);
    v("coagulated", coagulated), v("charred", charred);
  }
};

// Heat that is brought into a ball of tissue during a frame.
struct HeatSource {
  Vec3 place = Vec3::Zero();  // centre of the ball, in rest space, m
  double radius = 0;          // radius of the ball, m
  double power = 0;           // power of the source, W
};

class HeatField {
 public:
  static constexpr double kSpacing = 0.0015;  // side of a cell of the heat lattice, m

  HeatField() = default;
  // box: the bounding box of the organ at rest, m.
  explicit HeatField(const Aabb& box);

  // Computes a frame. duration: duration of the frame, s. isTissue: says whether there is tissue at
  // a point in rest space. The heat of the sources is added to the tissue in this call. Conduction,
  // perfusion, boiling and coagulation are computed for several frames together, about ten times a
  // second. If there is no source and no spot is warm, the spots stay as they are. Cost:
  // proportional to the number of spots.
  void step(std::span<const HeatSource> sources, double duration,
            const std::function<bool(const Vec3&)>& isTissue);

  // Drops the spots at which there is no tissue. isTissue: as in step().
  void keepIn(const std::function<bool(const Vec3&)>& isTissue);

  // Temperature (C), coagulated fraction and charred fraction at a point in rest space. They are
  // interpolated between the centres of the 8 nearest cells.
  double temperature(const Vec3& place) const;
  double coagulated(const Vec3& place) const;
  double charred(const Vec3& place) const;
  // Like coagulated(), but cells without tissue do not count. Meant for places at the surface of
  // the tissue, where some of the 8 cells are empty. isTissue: as in step().
  double coagulatedTissue(const Vec3& place,
                          const std::function<bool(const Vec3&)>& isTissue) const;

  const Lattice& lattice() const { return lattice_; }
  std::span<const HeatedSpot> spots() const { return spots_; }  // in ascending order of `index`
  bool empty() const { return spots_.empty(); }
  // Whether the coagulated or charred fraction of any spot grew noticeably in the last step().
  bool changed() const { return changed_; }
  // Water that becomes steam, kg/s; a mean over the last tenth of a second or so.
  double steamRate() const { return steamRate_; }
  // Energy of all spots together, J. It has two parts: the heat that has warmed the spots above 37
  // C, and the latent heat of the water that has become steam.
  double energy() const;

  template <class Visitor>
  void visit(Visitor& v) {
    v("spots", spots_), v("waited", waited_), v("steamRate", steamRate_);
  }
  template <class Visitor>
  void visitMade(Visitor& v) {
    v.made(lattice_, changed_, added_, flux_, bend_);
  }
  // For spots that were loaded from a saved state. Throws Error unless they are cells of the
  // lattice, in ascending order of `index`, with finite temperatures.
  void requireSound() const;

 private:
  const HeatedSpot* find(std::int64_t index) const;
  template <typename Value>
  double between(const Vec3& place, double elsewhere, Value value) const;
  template <typename Visit>
  void visitCorners(const Vec3& place, Visit visit) const;
  void add(const HeatSource& source, double duration,
           const std::function<bool(const Vec3&)>& isTissue);
  void advance(double duration, const std::function<bool(const Vec3&)>& isTissue);
  void spread(const std::function<bool(const Vec3&)>& isTissue);
  template <typename Visit>
  void visitPairs(const Vec3i& axis, Visit visit) const;
  void conduct(double duration);
  void insert();
  void forget();

  std::vector<HeatedSpot> spots_;
  Lattice lattice_;
  bool changed_ = false;
  double waited_ = 0;                // simulated time that is not yet computed, s
  double steamRate_ = 0;             // kg/s
  std::vector<std::int64_t> added_;  // work space of step(): indices of cells
  std::vector<double> flux_;         // work space of step(): heat flow into each spot, W
  std::vector<double> bend_;         // work space of step(): second difference at each spot, K
};

}  // namespace resect
