// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/check_history.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <set>

#include "armcal/core/diagnostics.h"
#include "armcal/core/random.h"
#include "armcal/io/check_table.h"
#include "armcal/io/sqlite_database.h"
#include "armcal/testing/temporary_folder.h"

namespace armcal {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryFolder;
using Missing = CheckHistory::Missing;

CheckRecord check_at(UtcSeconds time, double deviation_mm = 0.01) {
  CheckRecord check;
  check.time = time;
  check.arm = "ROMER 1234";
  check.arm_sha256 = "ab";
  check.artefact = "cone by the door";
  check.kind = "seat";
  check.point_count = 20;
  check.temperature_c = 20.4;
  check.verdict = "pass";
  check.readings_sha256 = "cd";
  check.tool_version = "0.1.0";
  check.note = "after the move";
  check.values = {{"max_deviation", deviation_mm, 0.05}, {"length", 500.0123456789, {}}};
  return check;
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return std::string("input: ") + error.what();
  } catch (const FileError& error) {
    return std::string("file: ") + error.what();
  }
  return "accepted";
}

std::string refusal(const std::string& path, Missing missing = Missing::create) {
  return message_of([&] { CheckHistory(path, missing); });
}

TEST(CheckHistory, GivesBackWhatWasSaved) {
  const TemporaryFolder folder;
  const std::string path = folder.path("checks.db");
  EXPECT_EQ(CheckHistory(path, Missing::create).append(check_at(1000)), 1);
  CheckRecord bare;
  bare.time = 2000;
  EXPECT_EQ(CheckHistory(path, Missing::create).append(bare), 2);
  const auto checks = CheckHistory(path, Missing::refuse).checks();
  ASSERT_EQ(checks.size(), 2u);
  const CheckRecord saved = check_at(1000);
  EXPECT_EQ(checks[0].time, saved.time);
  EXPECT_EQ(checks[0].arm, saved.arm);
  EXPECT_EQ(checks[0].arm_sha256, saved.arm_sha256);
  EXPECT_EQ(checks[0].artefact, saved.artefact);
  EXPECT_EQ(checks[0].kind, saved.kind);
  EXPECT_EQ(checks[0].point_count, saved.point_count);
  EXPECT_EQ(checks[0].temperature_c, saved.temperature_c);
  EXPECT_EQ(checks[0].verdict, saved.verdict);
  EXPECT_EQ(checks[0].readings_sha256, saved.readings_sha256);
  EXPECT_EQ(checks[0].tool_version, saved.tool_version);
  EXPECT_EQ(checks[0].note, saved.note);
  EXPECT_EQ(checks[0].values, saved.values);  // to the last digit and in their order
  EXPECT_TRUE(checks[1].values.empty());
  EXPECT_FALSE(checks[1].temperature_c.has_value());
}

TEST(CheckHistory, IsOrderedByTimeNotByArrival) {
  const TemporaryFolder folder;
  CheckHistory history(folder.path("checks.db"), Missing::create);
  for (const UtcSeconds time : {3000, 1000, 2000, 1000}) history.append(check_at(time));
  std::vector<std::int64_t> ids;
  for (const CheckRecord& check : history.checks()) ids.push_back(check.id);
  EXPECT_EQ(ids, (std::vector<std::int64_t>{2, 4, 3, 1}));
}

TEST(CheckHistory, IsOnlyAppendedTo) {
  const TemporaryFolder folder;
  const std::string path = folder.path("checks.db");
  CheckHistory(path, Missing::create).append(check_at(1000));
  SqliteDatabase database(path, SqliteDatabase::Missing::refuse);
  for (const char* sql : {"UPDATE checks SET verdict = 'pass'", "DELETE FROM checks",
                          "UPDATE check_values SET value_mm = 0", "DELETE FROM check_values"}) {
    try {
      database.execute(sql);
      ADD_FAILURE() << sql;
    } catch (const SqliteError& error) {
      EXPECT_THAT(error.what(), HasSubstr("only appended to"));
    }
  }
}

TEST(CheckHistory, RefusesWhatIsNoHistory) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal(folder.write("a.csv", "x,y\n1,2\n")),
              HasSubstr("a.csv: error: is no history"));
  EXPECT_THAT(refusal(folder.write("b.db", std::string("SQLite format 3\0", 16) + "nonsense")),
              HasSubstr("is no history of checks"));
  const std::string other = folder.path("other.db");
  SqliteDatabase(other, SqliteDatabase::Missing::create).execute("CREATE TABLE music (title TEXT)");
  EXPECT_THAT(refusal(other), HasSubstr("is an SQLite file, but no history of checks"));
  EXPECT_THAT(refusal(folder.path(".")), HasSubstr("is a folder"));
  EXPECT_THAT(refusal("-"), HasSubstr("must be a file, not a stream"));
  EXPECT_THAT(refusal("/dev/zero"), HasSubstr("is no file"));
  EXPECT_EQ(testing::read_bytes(folder.path("a.csv")), "x,y\n1,2\n");
}

TEST(CheckHistory, RefusesANewerVersion) {
  const TemporaryFolder folder;
  const std::string path = folder.path("checks.db");
  CheckHistory(path, Missing::create).append(check_at(1000));
  SqliteDatabase(path, SqliteDatabase::Missing::refuse).execute("PRAGMA user_version = 2");
  EXPECT_THAT(refusal(path),
              HasSubstr("was written by a newer armcal (history version 2, known up to 1)"));
}

TEST(CheckHistory, NamesThePlaceWhereItCannotBeKept) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal(folder.path("missing/checks.db")),
              AllOf(HasSubstr("file: "), HasSubstr("cannot write the history there"),
                    HasSubstr("choose a folder that exists")));
  EXPECT_THAT(refusal("/proc/checks.db"), HasSubstr("cannot write the history there"));
}

TEST(CheckHistory, IsNotMadeByLooking) {
  const TemporaryFolder folder;
  const std::string path = folder.path("checks.db");
  EXPECT_THAT(refusal(path, Missing::refuse), HasSubstr("does not exist"));
  EXPECT_FALSE(std::filesystem::exists(path));
  // An empty file is left by who is stopped while a history is made; it can be gone on with.
  folder.write("checks.db", "");
  EXPECT_THAT(refusal(path, Missing::refuse), HasSubstr("holds no check yet"));
  EXPECT_EQ(CheckHistory(path, Missing::create).append(check_at(1000)), 1);
}

TEST(CheckHistory, TakesNamesThatSqliteHasAMeaningFor) {
  const TemporaryFolder folder;
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path("."));
  CheckHistory(":memory:", Missing::create).append(check_at(1000));
  EXPECT_EQ(CheckHistory(":memory:", Missing::refuse).checks().size(), 1u);
  std::filesystem::current_path(before);
}

/// A program of its own that saves checks and tells of every one that it has saved; its number
/// comes through a pipe.
class Writer {
 public:
  explicit Writer(const std::string& path, int count, UtcSeconds first_time) {
    int ends[2];
    if (::pipe(ends) != 0) throw std::runtime_error("pipe failed");
    process_ = ::fork();
    if (process_ == 0) {
      ::close(ends[0]);
      write_checks(path, count, first_time, ends[1]);
    }
    ::close(ends[1]);
    reports_ = ends[0];
  }
  Writer(Writer&& other) noexcept
      : process_(std::exchange(other.process_, -1)), reports_(std::exchange(other.reports_, -1)) {}
  ~Writer() {
    if (reports_ >= 0) ::close(reports_);
  }

  /// Waits until it has said so often that a check is saved, or has ended.
  void wait_for(std::size_t count) {
    while (ids_.size() < count && read_one()) continue;
  }
  void kill_now() const { ::kill(process_, SIGKILL); }
  /// Waits for its end. @return the checks that it said were saved
  std::vector<std::int64_t> reported() {
    while (read_one()) continue;
    ::waitpid(process_, nullptr, 0);
    return ids_;
  }

 private:
  [[noreturn]] static void write_checks(const std::string& path, int count, UtcSeconds first_time,
                                        int reports) {
    try {
      for (int i = 0; i < count; ++i) {
        const std::int64_t id =
            CheckHistory(path, Missing::create).append(check_at(first_time + i));
        if (::write(reports, &id, sizeof id) != sizeof id) ::_exit(2);
      }
    } catch (const std::exception& error) {
      std::fputs(error.what(), stderr);
      ::_exit(1);
    }
    ::_exit(0);
  }

  bool read_one() {
    std::int64_t id = 0;
    if (::read(reports_, &id, sizeof id) != sizeof id) return false;
    ids_.push_back(id);
    return true;
  }

  pid_t process_ = -1;
  int reports_ = -1;
  std::vector<std::int64_t> ids_;
};

std::string integrity_of(const std::string& path) {
  SqliteDatabase database(path, SqliteDatabase::Missing::refuse);
  SqliteStatement query = database.prepare("PRAGMA integrity_check");
  return query.step() ? query.text(0) : "";
}

TEST(CheckHistory, HoldsEveryCheckThatWasReportedWhateverIsKilled) {
  RandomStream random(1);
  for (int file = 0; file < 6; ++file) {
    const TemporaryFolder folder;
    const std::string path = folder.path("checks.db");
    std::set<std::int64_t> reported;
    for (int kills = 1; kills <= 4; ++kills) {
      // Anywhere: while the file is made, after some checks, within a transaction.
      Writer writer(path, 1000, 1000 * kills);
      writer.wait_for(random.below(4));
      ::usleep(static_cast<useconds_t>(random.uniform(0.0, 1e4)));
      writer.kill_now();
      const auto ids = writer.reported();
      reported.insert(ids.begin(), ids.end());
      if (reported.empty()) continue;  // there may be no file yet
      EXPECT_EQ(integrity_of(path), "ok");
      std::set<std::int64_t> found;
      for (const CheckRecord& check : CheckHistory(path, Missing::refuse).checks()) {
        EXPECT_EQ(check.values.size(), 2u);  // none of them half
        found.insert(check.id);
      }
      EXPECT_TRUE(std::includes(found.begin(), found.end(), reported.begin(), reported.end()));
      // What is there beside was saved in the moment of a kill.
      EXPECT_LE(found.size(), reported.size() + static_cast<std::size_t>(kills));
    }
    EXPECT_FALSE(reported.empty());
  }
}

TEST(CheckHistory, TakesChecksOfSeveralProgramsAtOnce) {
  const TemporaryFolder folder;
  const std::string path = folder.path("checks.db");
  std::vector<Writer> writers;
  for (int i = 0; i < 4; ++i) writers.emplace_back(path, 10, 1000 * i);
  std::set<std::int64_t> reported;
  for (Writer& writer : writers) {
    const auto ids = writer.reported();
    EXPECT_EQ(ids.size(), 10u);
    reported.insert(ids.begin(), ids.end());
  }
  EXPECT_EQ(reported.size(), 40u);
  EXPECT_EQ(CheckHistory(path, Missing::refuse).checks().size(), 40u);
}

TEST(CheckTable, HasAColumnForEveryValueAndQuotesWhatNeedsIt) {
  CheckRecord seat = check_at(0, 0.0125);
  seat.id = 1;
  seat.note = "moved, \"hit\"";
  CheckRecord sphere = check_at(86400);
  sphere.id = 2;
  sphere.kind = "sphere";
  sphere.temperature_c.reset();
  sphere.values = {{"form_error", 0.02, {}}};
  EXPECT_EQ(csv_text(std::vector{seat, sphere}),
            "check,time_utc,arm,artefact,kind,points,temperature_c,verdict,max_deviation_mm,"
            "max_deviation_limit_mm,length_mm,length_limit_mm,form_error_mm,form_error_limit_mm,"
            "note,tool_version,arm_sha256,readings_sha256\n"
            "1,1970-01-01T00:00:00Z,ROMER 1234,cone by the door,seat,20,20.4,pass,0.0125,0.05,"
            "500.0123456789,,,,\"moved, \"\"hit\"\"\",0.1.0,ab,cd\n"
            "2,1970-01-02T00:00:00Z,ROMER 1234,cone by the door,sphere,20,,pass,,,,,0.02,,after "
            "the move,0.1.0,ab,cd\n");
}

}  // namespace
}  // namespace armcal
