/// @file Friction (Formulation 8, steps 1 to 10): the coefficient, the filter, the return of the trial force to its
/// limit.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "optimized/projection/vector3.h"
#include "reference/contract/scene.h"

namespace type21::optimized {

/// mu of pressure p and sliding speed s, of one set of numbers.
/// @manual eq 9, 10, 11; field Ifric; comment 13; departure D10, D39, D43
class FrictionLaw {
  public:
    FrictionLaw() = default;
    FrictionLaw(int ifric, const AsBuilt& as_built)
        : ifric_(ifric),
          reversed_(as_built.has(Departure::D10)),
          unbounded_(as_built.has(Departure::D39)),
          drops_(as_built.has(Departure::D43)) {}

    /// Not finite where an exponential or a square overflows; D43: then the least coefficient.
    /// @param factor  f_IDF, scales Fric of law 0 [-]
    double coefficient(const FrictionCoefficients& f, double p, double s, double factor) const;
    /// The rank among C1..C6, from 0, of the number that makes it so.
    int overflowing(const FrictionCoefficients& f, double s) const;

  private:
    /// c e^(x s); 0 where c is 0, whatever the exponential.
    double exponential(double c, double x, double s) const;

    int ifric_ = 0;
    bool reversed_ = false;
    bool unbounded_ = false;  ///< D39: law 0 may be negative
    bool drops_ = false;      ///< D43
};

/// Which numbers hold for a pair of parts: those of the card, or those of /FRICTION.
/// @manual field fric_ID; departure D42
class FrictionTable {
  public:
    FrictionTable() = default;
    FrictionTable(const ContactModel& model, const Interface& interface);

    bool by_parts() const { return !secondary_part_.empty(); }
    const FrictionCoefficients& at(int node, int segment) const;
    size_t bytes_per_node() const { return by_parts() ? sizeof(int) : 0; }

  private:
    FrictionCoefficients common_;
    std::vector<FrictionPair> pairs_;
    std::vector<int> secondary_part_, main_part_;  ///< of each node and of each segment, -1: none; empty without pairs
};

/// alpha of the filter for a step dt1 of the increment: 1 without a filter, never above 1 but for D06.
/// @manual eq 13; field Ifiltr, Xfreq; comment 15; departure D06, D07, D28
double filter_share(const Interface& interface, double step, const AsBuilt& as_built);

/// F_t and what it was before the limit.
struct Tangential {
    V3 force;  ///< F_t, on the tool [force]
    V3 trial;  ///< T [force]
    bool slides;
};

/// T is the old force and the increment k v dt1, both brought to the plane normal to nu; F_t is T shortened to the
/// limit.
/// @param growth  alpha k dt1 [force time/length]
/// @manual eq 12; comment 14
inline Tangential returned_to_limit(const V3& old, const V3& velocity, double growth, const V3& nu, double limit) {
    const V3 sum = old + velocity * growth;
    const V3 trial = sum - nu * dot(sum, nu);
    const double size = norm(trial);
    if (size <= limit || size == 0) return {trial, trial, false};
    return {trial * (limit / size), trial, true};
}

/// |F_t| sqrt 3 / (Pskid A) of a sliding node, at most 1.
/// @manual field Pskid
inline double skid_share(double force, double pskid, double area) {
    if (!(area > 0)) return 0;
    const double share = force * std::sqrt(3.0) / (pskid * area);
    return share < 1 ? share : 1.0;
}

}  // namespace type21::optimized
