// Temperature of tissue and what heat has done to it, round the places that were heated.
//
// The bioheat equation (Pennes 1948) on a lattice of its own, in the tissue at rest, whatever the
// size of the organ's cells:
//
//     rho c dT/dt = k laplacian(T) - w rho_b c_b (1 - coagulated) (T - 37) + source
//
// Water boils at 100 C: until it is gone, more heat makes steam instead of a higher temperature.
// Coagulation is a reaction of first order, whose rate follows Eyring's law with the enthalpy and
// entropy that were measured on pig liver by Jacques, Newman and He (1991). Dry tissue chars.
//
// Only spots that are warm or changed are held; elsewhere tissue is at 37 C. Nothing flows through
// the tissue's surface. Vessels do not cool it (an estimate of their effect is the perfusion).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "sph/lattice.h"

namespace resect {

// Of liver: Duck 1990; perfusion 1 ml/(ml min) and less by Ebbini et al. 1988.
inline constexpr double kBodyTemperature = 37;         // C
inline constexpr double kConductivity = 0.52;          // k, W/(m K)
inline constexpr double kHeatCapacity = 1060 * 3600;   // rho c, J/(m^3 K)
inline constexpr double kPerfusion = 6.4e-3;           // w, 1/s
inline constexpr double kBloodCapacity = 1060 * 3640;  // rho_b c_b, J/(m^3 K)

// Rate at which tissue coagulates at a temperature in C, 1/s.
double coagulationRate(double temperature);

// A place of the heat lattice.
struct HeatedSpot {
  std::int64_t index = -1;                // in HeatField::lattice()
  double temperature = kBodyTemperature;  // C
  double water = 1;                       // share of its water that is left
  double coagulated = 0, charred = 0;     // shares, 0 to 1

  template <class Visitor>
  void visit(Visitor& v) {
    v("index", index), v("temperature", temperature), v("water", water);
    v("coagulated", coagulated), v("charred", charred);
  }
};

// Heat that is brought into a ball in a frame.
struct HeatSource {
  Vec3 place = Vec3::Zero();  // in the tissue at rest, m
  double radius = 0;          // m
  double power = 0;           // W
};

class HeatField {
 public:
  static constexpr double kSpacing = 0.0015;  // m, of the lattice

  HeatField() = default;
  // box: round the organ at rest, m.
  explicit HeatField(const Aabb& box);

  // A frame. isTissue: whether there is tissue at a place at rest. Cost: the spots; nothing if no
  // spot is warm and nothing heats.
  void step(std::span<const HeatSource> sources, double duration,
            const std::function<bool(const Vec3&)>& isTissue);

  // Forgets the spots without tissue.
  void keepIn(const std::function<bool(const Vec3&)>& isTissue);

  // At a place at rest, between the spots round it.
  double temperature(const Vec3& place) const;
  double coagulated(const Vec3& place) const;
  double charred(const Vec3& place) const;

  const Lattice& lattice() const { return lattice_; }
  std::span<const HeatedSpot> spots() const { return spots_; }  // ascending
  bool empty() const { return spots_.empty(); }
  // Whether anything has coagulated or charred further in the last step().
  bool changed() const { return changed_; }
  // Water that became steam in the last step(), kg.
  double steam() const { return steam_; }
  // Heat above 37 C and that of the steam, J.
  double energy() const;

  template <class Visitor>
  void visit(Visitor& v) {
    v("spots", spots_);
  }
  template <class Visitor>
  void visitMade(Visitor& v) {
    v.made(lattice_, changed_, steam_, added_, flux_);
  }
  // Throws Error if spots that were loaded do not belong to the lattice.
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
  std::vector<std::int64_t> added_;  // work
  std::vector<double> flux_;         // work: into each spot, W
};

}  // namespace resect
