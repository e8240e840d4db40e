// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <span>
#include <sstream>

#include "armcal/cli/commands.h"
#include "armcal/testing/reference_data.h"
#include "armcal/testing/temporary_folder.h"
#include "armcal/testing/tool.h"

// What the documentation shows is what the tool prints: every command of the help texts and of the
// pages is run here.
namespace armcal::cli {
namespace {

using testing::repository;
using testing::tool;

/// A folder from which the examples are reached as from the top of the repository, and which takes
/// what commands write.
class PlayGround {
 public:
  PlayGround() : before_(std::filesystem::current_path()) {
    std::filesystem::create_symlink(repository() / "examples", folder_.path("examples"));
    std::filesystem::current_path(folder_.path("."));
  }
  ~PlayGround() { std::filesystem::current_path(before_); }
  PlayGround(const PlayGround&) = delete;
  PlayGround& operator=(const PlayGround&) = delete;

 private:
  testing::TemporaryFolder folder_;
  std::filesystem::path before_;
};

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

testing::ToolResult run_line(const std::string& line) {
  std::vector<std::string> words = words_of(line);
  EXPECT_EQ(words.front(), "armcal") << line;
  words.erase(words.begin());
  return tool(words);
}

void expect_examples_run(const std::vector<Command>& commands) {
  for (const Command& command : commands) {
    for (const std::string& line : command.examples) {
      const auto result = run_line(line);
      EXPECT_TRUE(result.code == kDone || result.code == kDoesNotConform) << line << '\n'
                                                                          << result.err;
      EXPECT_TRUE(!result.out.empty() || line.find(" -o ") != line.npos) << line;
    }
    EXPECT_FALSE(command.examples.empty() && command.subcommands.empty()) << command.name;
    expect_examples_run(command.subcommands);
  }
}

TEST(Documentation, ExamplesOfTheHelpTextsRun) {
  const PlayGround ground;
  expect_examples_run(all_commands());
}

struct Session {
  std::string page;
  int line = 0;
  std::string command;
  std::string shown;  // output as printed on the page
};

/// Every `$ armcal ..` of the ```console blocks with the lines that follow it.
std::vector<Session> sessions_of(const std::filesystem::path& page) {
  std::vector<Session> sessions;
  std::ifstream file(page);
  bool in_console = false;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (line.rfind("```", 0) == 0) {
      in_console = line == "```console";
    } else if (in_console && line.rfind("$ ", 0) == 0) {
      sessions.push_back(
          {std::filesystem::relative(page, repository()).string(), number, line.substr(2), ""});
    } else if (in_console) {
      EXPECT_FALSE(sessions.empty())
          << page << ':' << number << ": output before the first command";
      if (!sessions.empty()) sessions.back().shown += line + '\n';
    }
  }
  return sessions;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// A line `...` on the page stands for any lines.
bool agrees(std::span<const std::string> shown, std::span<const std::string> printed) {
  if (shown.empty()) return printed.empty();
  if (shown.front() == "...") {
    for (std::size_t skipped = 0; skipped <= printed.size(); ++skipped) {
      if (agrees(shown.subspan(1), printed.subspan(skipped))) return true;
    }
    return false;
  }
  return !printed.empty() && shown.front() == printed.front() &&
         agrees(shown.subspan(1), printed.subspan(1));
}

std::vector<std::filesystem::path> pages() {
  std::vector<std::filesystem::path> found = {repository() / "README.md"};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(repository() / "docs")) {
    if (entry.path().extension() == ".md") found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

TEST(Documentation, ShowsWhatTheToolPrints) {
  const PlayGround ground;
  int count = 0;
  for (const auto& page : pages()) {
    for (const Session& session : sessions_of(page)) {
      const auto result = run_line(session.command);
      EXPECT_TRUE(agrees(lines_of(session.shown), lines_of(result.err + result.out)))
          << session.page << ':' << session.line << ": " << session.command
          << "\n--- the page shows\n"
          << session.shown << "--- the tool prints\n"
          << result.err << result.out;
      ++count;
    }
  }
  EXPECT_GT(count, 10);
}

TEST(Documentation, HasAPageForEveryCommand) {
  for (const Command& command : all_commands()) {
    const auto page = repository() / "docs/commands" / (command.name + ".md");
    ASSERT_TRUE(std::filesystem::exists(page)) << page;
    const std::string text = testing::read_bytes(page);
    std::vector<Command> all = command.subcommands;
    all.push_back(command);
    for (const Command& each : all) {
      for (const Argument& argument : each.arguments) {
        const std::string spelling =
            argument.is_positional() ? argument.name : argument.spellings().back();
        EXPECT_NE(text.find(spelling), text.npos) << page << " says nothing of " << spelling;
      }
    }
  }
}

TEST(Documentation, LinksLeadSomewhere) {
  static const std::regex link(R"(\]\(([^)#:]+)(#[^)]*)?\))");
  for (const auto& page : pages()) {
    const std::string text = testing::read_bytes(page);
    for (std::sregex_iterator at(text.begin(), text.end(), link), end; at != end; ++at) {
      EXPECT_TRUE(std::filesystem::exists(page.parent_path() / (*at)[1].str()))
          << page << ": " << (*at)[1];
    }
  }
}

/// Numbers N of the equations "(N)" that a theory page defines: lines that end in the number.
std::set<int> equations_of(const std::filesystem::path& page) {
  static const std::regex numbered(R"(\((\d+)\)\s*$)");
  std::set<int> numbers;
  std::ifstream file(page);
  for (std::string line; std::getline(file, line);) {
    std::smatch match;
    if (std::regex_search(line, match, numbered)) numbers.insert(std::stoi(match[1]));
  }
  return numbers;
}

TEST(Documentation, SourcesCiteEquationsThatExist) {
  static const std::regex citation(R"(theory/(\w+)\.md(?:[\s/]+eq\.[\s/]+((?:\(\d+\)[-, ]*)+))?)");
  static const std::regex number(R"(\((\d+)\))");
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(repository() / "src")) {
    if (entry.path().extension() != ".h" && entry.path().extension() != ".cc") continue;
    if (entry.path().filename() == "documentation_test.cc") continue;
    const std::string text = testing::read_bytes(entry.path());
    for (std::sregex_iterator at(text.begin(), text.end(), citation), end; at != end; ++at) {
      const auto page = repository() / "docs/theory" / ((*at)[1].str() + ".md");
      ASSERT_TRUE(std::filesystem::exists(page)) << entry.path() << " cites " << page;
      const std::set<int> known = equations_of(page);
      const std::string cited = (*at)[2];
      for (std::sregex_iterator n(cited.begin(), cited.end(), number); n != end; ++n) {
        EXPECT_TRUE(known.contains(std::stoi((*n)[1])))
            << entry.path() << " cites eq. (" << (*n)[1] << ") of " << page;
        ++count;
      }
    }
  }
  EXPECT_GT(count, 20);
}

}  // namespace
}  // namespace armcal::cli
