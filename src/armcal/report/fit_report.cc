// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/fit_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "armcal/core/units.h"
#include "armcal/report/number_format.h"

namespace armcal {
namespace {

constexpr int kLengthDecimals = 6;     // 1 nm
constexpr int kDirectionDecimals = 9;  // 1 nrad

void add_summary(Json& json, const FitSummary& fit, bool with_form) {
  json["rms_mm"] = fit.rms_mm;
  if (with_form) json["form_mm"] = fit.form_mm;
  json["count"] = fit.count;
  json["degrees_of_freedom"] = fit.degrees_of_freedom;
  json["covariance_of"] = fit.covariance_of;
  json["covariance"] = fit.covariance ? json_of(*fit.covariance) : Json();
  json["residuals_mm"] = json_of(fit.residuals_mm);
  json["status"] = to_string(fit.status);
}

std::string uncertainty(const FitSummary& fit, std::string_view quantity, int decimals) {
  const auto u = fit.standard_uncertainty(quantity);
  return u ? fmt::format("   u {}", fixed(*u, decimals)) : "";
}

std::string line_of(std::string_view name, std::string_view value, std::string_view rest = "") {
  std::string line = fmt::format("  {:<12}{:>18}{}", name, value, rest);
  line.erase(line.find_last_not_of(' ') + 1);
  return line + '\n';
}

std::string vector_text(const FitSummary& fit, std::string_view name, const Eigen::Vector3d& v,
                        std::string_view prefix, int decimals, std::string_view unit) {
  constexpr std::string_view kAxes[] = {"x", "y", "z"};
  std::string text;
  for (int k = 0; k < 3; ++k) {
    const std::string quantity = fmt::format("{}{}", prefix, kAxes[k]);
    text += line_of(fmt::format("{} {}", name, kAxes[k]), fixed(v(k), decimals),
                    fmt::format("{}{}", unit, uncertainty(fit, quantity, decimals)));
  }
  return text;
}

std::string head_text(std::string_view element, const FitSummary& fit) {
  std::string text = fmt::format("Least-squares {} through {} points", element, fit.count);
  if (!fit.covariance) {
    text += fit.degrees_of_freedom > 0 ? "" : " (as many as it needs: no scatter to judge by)";
  }
  return text + "\n";
}

std::string quality_text(const FitSummary& fit, std::string_view form) {
  return line_of("rms", fixed(fit.rms_mm, kLengthDecimals), " mm") +
         line_of(form, fixed(fit.form_mm, kLengthDecimals), " mm");
}

}  // namespace

Json json_result(const CircleFit& fit) {
  Json json;
  json["center_mm"] = json_of(Eigen::VectorXd(fit.center_mm));
  json["normal"] = json_of(Eigen::VectorXd(fit.normal));
  json["radius_mm"] = fit.radius_mm;
  add_summary(json, fit, true);
  return json;
}

Json json_result(const SphereFit& fit) {
  Json json;
  json["center_mm"] = json_of(Eigen::VectorXd(fit.center_mm));
  json["radius_mm"] = fit.radius_mm;
  add_summary(json, fit, true);
  return json;
}

Json json_result(const PlaneFit& fit) {
  Json json;
  json["point_mm"] = json_of(Eigen::VectorXd(fit.point_mm));
  json["normal"] = json_of(Eigen::VectorXd(fit.normal));
  add_summary(json, fit, true);
  return json;
}

Json json_result(const LineFit& fit) {
  Json json;
  json["point_mm"] = json_of(Eigen::VectorXd(fit.point_mm));
  json["direction"] = json_of(Eigen::VectorXd(fit.direction));
  add_summary(json, fit, true);
  return json;
}

Json json_result(const Registration& fit) {
  Json json;
  json["rotation"] = json_of(Eigen::MatrixXd(fit.target_from_source.rotation));
  json["translation_mm"] = json_of(Eigen::VectorXd(fit.target_from_source.translation_mm));
  const Eigen::Vector3d angles_rad = roll_pitch_yaw_from_rotation(fit.target_from_source.rotation);
  json["roll_pitch_yaw_deg"] = json_of(Eigen::VectorXd(angles_rad * degrees_from_radians(1.0)));
  json["scale"] = fit.scale;
  add_summary(json, fit, false);
  json["max_mm"] = fit.form_mm;
  return json;
}

std::string text_result(const CircleFit& fit) {
  return head_text("circle", fit) +
         vector_text(fit, "center", fit.center_mm, "", kLengthDecimals, " mm") +
         vector_text(fit, "normal", fit.normal, "normal_", kDirectionDecimals, "   ") +
         line_of("radius", fixed(fit.radius_mm, kLengthDecimals),
                 " mm" + uncertainty(fit, "radius", kLengthDecimals)) +
         quality_text(fit, "roundness");
}

std::string text_result(const SphereFit& fit) {
  return head_text("sphere", fit) +
         vector_text(fit, "center", fit.center_mm, "", kLengthDecimals, " mm") +
         line_of("radius", fixed(fit.radius_mm, kLengthDecimals),
                 " mm" + uncertainty(fit, "radius", kLengthDecimals)) +
         quality_text(fit, "form");
}

std::string text_result(const PlaneFit& fit) {
  return head_text("plane", fit) +
         vector_text(fit, "point", fit.point_mm, "", kLengthDecimals, " mm") +
         vector_text(fit, "normal", fit.normal, "normal_", kDirectionDecimals, "   ") +
         quality_text(fit, "flatness");
}

std::string text_result(const LineFit& fit) {
  return head_text("line", fit) +
         vector_text(fit, "point", fit.point_mm, "", kLengthDecimals, " mm") +
         vector_text(fit, "direction", fit.direction, "direction_", kDirectionDecimals, "   ") +
         quality_text(fit, "straightness");
}

std::string text_result(const Registration& fit) {
  std::string text =
      fmt::format("Rigid transform between {} paired points: second = {}R * first + t\n", fit.count,
                  fit.scale == 1.0 ? "" : "scale * ");
  const Eigen::Matrix3d& rotation = fit.target_from_source.rotation;
  for (int row = 0; row < 3; ++row) {
    text += fmt::format("  {:<12}{:>16}{:>16}{:>16}\n", row == 0 ? "R" : "",
                        fixed(rotation(row, 0), kDirectionDecimals),
                        fixed(rotation(row, 1), kDirectionDecimals),
                        fixed(rotation(row, 2), kDirectionDecimals));
  }
  text += vector_text(fit, "t", fit.target_from_source.translation_mm, "", kLengthDecimals, " mm");
  const Eigen::Vector3d angles = roll_pitch_yaw_from_rotation(rotation);
  text += line_of("roll", fixed(degrees_from_radians(angles.x()), kLengthDecimals), " deg") +
          line_of("pitch", fixed(degrees_from_radians(angles.y()), kLengthDecimals), " deg") +
          line_of("yaw", fixed(degrees_from_radians(angles.z()), kLengthDecimals), " deg");
  if (fit.scale != 1.0) {
    text += line_of("scale", fixed(fit.scale, kDirectionDecimals),
                    "   " + uncertainty(fit, "scale", kDirectionDecimals));
  }
  return text + line_of("rms", fixed(fit.rms_mm, kLengthDecimals), " mm") +
         line_of("largest", fixed(fit.form_mm, kLengthDecimals), " mm");
}

}  // namespace armcal
