// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/core/utc_time.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

namespace armcal {
namespace {

// Takes what it reads from the front of a text.
class Reader {
 public:
  explicit Reader(std::string_view text) : rest_(text) {}

  [[nodiscard]] bool at_end() const { return rest_.empty(); }
  bool take(char c) {
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  // A number of exactly so many digits.
  std::optional<int> digits(std::size_t count) {
    if (rest_.size() < count) return std::nullopt;
    int value = 0;
    for (const char c : rest_.substr(0, count)) {
      if (c < '0' || c > '9') return std::nullopt;
      value = 10 * value + (c - '0');
    }
    rest_.remove_prefix(count);
    return value;
  }
  std::optional<int> digits(std::size_t count, int most) {
    const auto value = digits(count);
    return value && *value <= most ? value : std::nullopt;
  }

 private:
  std::string_view rest_;
};

std::optional<std::chrono::seconds> day_of(Reader& reader) {
  const auto year = reader.digits(4);
  if (!year || !reader.take('-')) return std::nullopt;
  const auto month = reader.digits(2);
  if (!month || !reader.take('-')) return std::nullopt;
  const auto day = reader.digits(2);
  if (!day) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(*year),
                                         std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day))};
  if (!date.ok() || *year < 1970) return std::nullopt;
  return std::chrono::sys_days(date).time_since_epoch();
}

// "09:15" or "09:15:30"
std::optional<std::chrono::seconds> clock_of(Reader& reader) {
  const auto hours = reader.digits(2, 23);
  if (!hours || !reader.take(':')) return std::nullopt;
  const auto minutes = reader.digits(2, 59);
  if (!minutes) return std::nullopt;
  std::optional<int> seconds = 0;
  if (reader.take(':')) seconds = reader.digits(2, 59);
  if (!seconds) return std::nullopt;
  return std::chrono::hours(*hours) + std::chrono::minutes(*minutes) +
         std::chrono::seconds(*seconds);
}

// What is ahead of UTC: "Z", "+01:00" or nothing.
std::optional<std::chrono::seconds> zone_of(Reader& reader) {
  if (reader.at_end() || reader.take('Z')) return std::chrono::seconds(0);
  const int sign = reader.take('+') ? 1 : reader.take('-') ? -1 : 0;
  if (sign == 0) return std::nullopt;
  const auto offset = clock_of(reader);
  if (!offset) return std::nullopt;
  return sign * *offset;
}

}  // namespace

std::optional<UtcSeconds> parse_utc_time(std::string_view text) {
  Reader reader(text);
  const auto day = day_of(reader);
  if (!day) return std::nullopt;
  if (reader.at_end()) return day->count();
  if (!reader.take('T') && !reader.take(' ')) return std::nullopt;
  const auto clock = clock_of(reader);
  if (!clock) return std::nullopt;
  const auto zone = zone_of(reader);
  if (!zone || !reader.at_end()) return std::nullopt;
  const UtcSeconds time = (*day + *clock - *zone).count();
  if (time < 0) return std::nullopt;
  return time;
}

std::string utc_text(UtcSeconds time) {
  using std::chrono::sys_days;
  const std::chrono::sys_seconds point{std::chrono::seconds(time)};
  const sys_days midnight = std::chrono::floor<std::chrono::days>(point);
  const std::chrono::year_month_day date(midnight);
  const std::chrono::hh_mm_ss clock(point - midnight);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                     clock.hours().count(), clock.minutes().count(), clock.seconds().count());
}

std::optional<double> parse_fractional_utc_time(std::string_view text) {
  constexpr std::size_t kBeforeFraction = std::string_view("2026-03-02T09:15:30").size();
  const bool has_fraction = text.size() > kBeforeFraction &&
                            (text[kBeforeFraction] == '.' || text[kBeforeFraction] == ',');
  std::string whole(text);
  double fraction_s = 0.0;
  if (has_fraction) {
    std::size_t end = kBeforeFraction + 1;
    for (double place = 0.1; end < text.size() && text[end] >= '0' && text[end] <= '9'; ++end) {
      fraction_s += place * (text[end] - '0');
      place /= 10.0;
    }
    if (end == kBeforeFraction + 1) return std::nullopt;
    whole.erase(kBeforeFraction, end - kBeforeFraction);
  }
  const auto time = parse_utc_time(whole);
  if (!time) return std::nullopt;
  return static_cast<double>(*time) + fraction_s;
}

std::string fractional_utc_text(double time_s) {
  const auto milliseconds = static_cast<std::int64_t>(std::llround(1000.0 * time_s));
  std::string text = utc_text(milliseconds / 1000);
  if (milliseconds % 1000 == 0) return text;
  text.pop_back();
  return text + fmt::format(".{:03}Z", milliseconds % 1000);
}

}  // namespace armcal
