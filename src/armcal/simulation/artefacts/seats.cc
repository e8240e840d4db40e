// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/simulation/artefacts/seats.h"

#include "armcal/observations/empty_group.h"
#include "armcal/simulation/contact.h"

namespace armcal {

ObservationGroup measure_seats(Laboratory& laboratory, const std::string& name,
                               const std::vector<Feature>& seats, int postures, double u_mm) {
  const int rows = static_cast<int>(seats.size()) * postures;
  ObservationGroup group = empty_group(ReferenceKind::fixed_point, name, rows,
                                       laboratory.arm().truth().joint_count(), u_mm);
  for (const Feature& seat : seats) {
    group.encoder_rad.middleCols(static_cast<Eigen::Index>(group.place.size()), postures) =
        take_in_seat(laboratory, seat, seat.name, postures, u_mm);
    group.place.insert(group.place.end(), static_cast<std::size_t>(postures), seat.name);
  }
  return group;
}

ObservationGroup no_lengths(const std::string& name) {
  return empty_group(ReferenceKind::length, name, 0, 0, 0.0);
}

void add_length(Laboratory& laboratory, const std::string& from, const std::string& to,
                double length_mm, double u_mm, ObservationGroup& lengths) {
  const int count = static_cast<int>(lengths.count()) + 1;
  const ObservationGroup row = empty_group(ReferenceKind::length, lengths.name, count, 0, u_mm);
  lengths.lines = row.lines;
  lengths.is_check = row.is_check;
  lengths.u_mm.conservativeResize(count);
  lengths.u_mm(count - 1) = row.u_mm(count - 1);
  lengths.value_mm.conservativeResize(count);
  lengths.value_mm(count - 1) = length_mm + u_mm * laboratory.random().normal();
  lengths.place.push_back(from);
  lengths.place_to.push_back(to);
}

}  // namespace armcal
