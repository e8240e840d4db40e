// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/workflow/pdf_print.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>
#include <thread>
#include <vector>

#include "armcal/core/diagnostics.h"
#include "armcal/workflow/programs.h"

namespace armcal {
namespace {

using namespace std::chrono_literals;
constexpr auto kLongest = 120s;
constexpr std::string_view kPrintElsewhere =
    "\n  help: write the report as HTML and print it from any browser; ARMCAL_BROWSER names "
    "another "
    "one to print with";

// A folder that goes when its work is done.
class WorkFolder {
 public:
  WorkFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "armcal-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) {
      throw FileError("cannot make a temporary folder to print from");
    }
    path_ = pattern;
  }
  ~WorkFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  [[nodiscard]] std::string file(const char* name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

std::string read_all(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// The browser and its helpers.
void end(pid_t child) { kill(-child, SIGKILL); }

// @return its exit status; 0 where the system keeps none for us, and what it printed has to tell
int wait_for(pid_t child, const Monitor& monitor) {
  const auto begin = std::chrono::steady_clock::now();
  for (;;) {
    int status = 0;
    const pid_t ended = waitpid(child, &status, WNOHANG);
    if (ended == child || (ended < 0 && errno != EINTR)) {
      end(child);  // helpers that are still busy with the folder
      return ended == child ? status : 0;
    }
    if (monitor.stop.stop_requested()) {
      end(child);
      waitpid(child, nullptr, 0);
      throw Interrupted();
    }
    if (std::chrono::steady_clock::now() - begin > kLongest) {
      end(child);
      waitpid(child, nullptr, 0);
      throw FileError(fmt::format("the browser did not print within {} s{}", kLongest.count(),
                                  kPrintElsewhere));
    }
    std::this_thread::sleep_for(20ms);
  }
}

std::string last_line(const std::string& text) {
  std::istringstream stream(text);
  std::string last;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

}  // namespace

std::string printing_browser() {
  if (const char* named = std::getenv("ARMCAL_BROWSER"); named != nullptr && *named != '\0') {
    if (is_program(named)) return named;
    // A name alone is looked for as the shell does.
    const std::array<std::string_view, 1> names = {named};
    auto program =
        names[0].find('/') == std::string_view::npos ? program_in_path(names) : std::nullopt;
    if (program) return std::move(*program);
    throw FileError(fmt::format("ARMCAL_BROWSER names {}, which is no program", named));
  }
  constexpr std::array<std::string_view, 4> kNames = {"chromium", "chromium-browser",
                                                      "google-chrome", "google-chrome-stable"};
  if (auto program = program_in_path(kNames)) return std::move(*program);
  throw FileError(
      "no Chromium to print with: install it, or open the HTML report in any browser and print it "
      "from there");
}

void print_as_pdf(const std::string& html, const std::string& browser, const std::string& pdf_path,
                  Overwrite overwrite, const Monitor& monitor) {
  const WorkFolder folder;
  const std::string page = folder.file("report.html");
  const std::string pdf = folder.file("report.pdf");
  const std::string log = folder.file("log");
  write_file(page, html, Overwrite::refuse);
  std::vector<std::string> words = {browser,
                                    "--headless",
                                    "--disable-gpu",
                                    "--no-first-run",
                                    "--disable-extensions",
                                    "--disable-background-networking",
                                    "--no-pdf-header-footer",
                                    "--user-data-dir=" + folder.file("profile"),
                                    "--print-to-pdf=" + pdf};
  // Chromium's own sandbox does not start for the superuser (containers); the page is our own and
  // its policy lets it fetch nothing.
  if (geteuid() == 0) words.emplace_back("--no-sandbox");
  words.push_back(file_url(page));
  const int status = wait_for(start_program(words, log, Belonging::own_group), monitor);
  const std::string bytes = read_all(pdf);
  if (status != 0 || bytes.rfind("%PDF", 0) != 0) {
    const std::string said = last_line(read_all(log));
    throw FileError(fmt::format("{} did not print the report{}{}{}", browser,
                                said.empty() ? ", and did not say why" : ": ", said,
                                kPrintElsewhere));
  }
  write_file(pdf_path, bytes, overwrite);
}

}  // namespace armcal
