// suture fuzz: campaigns over ranges of seeds, replays, single cases, merged summaries.
#include <fmt/format.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "kernel/errors.h"
#include "kernel/files.h"
#include "sims/cli/choices.h"
#include "sims/cli/commands.h"
#include "sims/cli/inputs.h"
#include "sims/fuzz/campaign.h"
#include "sims/fuzz/case_file.h"
#include "sims/fuzz/case_maker.h"
#include "sims/fuzz/corpus.h"
#include "sims/fuzz/execute.h"
#include "sims/support/version.h"
#include "surgery/model/option_table.h"

namespace suture::sims {
namespace {

namespace fs = std::filesystem;

struct Settings {
  CampaignOptions campaign;
  CaseOptions cases;
  TrackerOptions tracker;  ///< of all cases, where flags say so
  std::string oracles = "sampled";
  std::vector<std::string> replay, merge;
  std::uint64_t show = 0;
  fs::path corpus, summary, out;
  MinimiseLimits limits;
};

/// One line on a terminal, drawn again as the campaign goes on.
class FuzzProgress {
 public:
  ~FuzzProgress() {
    if (drawn_) fmt::print(stderr, "\n");
  }
  void draw(const FuzzSummary& s, double seconds, const CampaignOptions& asked) {
    if (isatty(STDERR_FILENO) != 1) return;
    constexpr double width = 24;
    double part =
        asked.cases > 0 ? static_cast<double>(s.cases) / static_cast<double>(asked.cases) : 0;
    if (asked.seconds > 0) part = std::max(part, seconds / asked.seconds);
    const int full = static_cast<int>(width * std::min(part, 1.0));
    fmt::print(stderr, "\r[{:#<{}}{:.<{}}] {} cases  {} surgeries, {:.0f}/s  {} failures   ", "",
               full, "", static_cast<int>(width) - full, s.cases, s.surgeries,
               seconds > 0 ? static_cast<double>(s.surgeries) / seconds : 0, s.failures.size());
    std::fflush(stderr);
    drawn_ = true;
  }

 private:
  bool drawn_ = false;
};

/// The word for the option called `name`.
std::string word_of(const TrackerOptions& options, const std::string& name) {
  return in_words(*tracker_options().row(name).field.get(options));
}

std::string profile_name(Profile profile) {
  for (const auto& named : kProfileNames)
    if (named.value == profile) return named.name;
  return {};
}

void print_failures(const FuzzSummary& s) {
  constexpr std::size_t kMost = 20;
  for (std::size_t i = 0; i < s.failures.size() && i < kMost; ++i) {
    const FuzzFailure& f = s.failures[i];
    fmt::print("seed {}: {}: {}{}\n", f.seed, f.check, f.cause,
               f.file.empty() ? "" : "; saved as " + f.file);
  }
  if (s.failures.size() > kMost) fmt::print("and {} more\n", s.failures.size() - kMost);
}

void print_summary(const FuzzSummary& s) {
  std::uint64_t refused = 0;
  for (const auto& [cause, count] : s.refused) refused += count;
  print_failures(s);
  fmt::print(
      "{} cases, {} remodels of which {} changed the mesh and {} were refused; {} failures; {:.1f} "
      "s, {:.0f} surgeries a second; digest {:016x}\n",
      s.cases, s.remodels, s.surgeries, refused, s.failures.size(), s.wall_seconds,
      s.wall_seconds > 0 ? static_cast<double>(s.surgeries) / s.wall_seconds : 0, s.digest);
}

int finish(const FuzzSummary& summary, const fs::path& file) {
  if (!file.empty()) write_file(file, to_json(summary).dump(1) + "\n");
  print_summary(summary);
  return summary.failures.empty() ? kDone : kNo;
}

int run_cases(const Settings& s) {
  if (!s.summary.empty()) require_folder_of(s.summary);
  const CheckChoice oracles(s.oracles);
  FuzzSummary summary;
  {
    FuzzProgress progress;
    summary = run_campaign(
        s.campaign,
        [&](std::uint64_t seed) { return run_case(make_case(seed, s.cases), oracles).counts; },
        [&](const FuzzSummary& so_far, double seconds) {
          progress.draw(so_far, seconds, s.campaign);
        });
  }
  summary.settings = {kVersion,
                      profile_name(s.cases.profile),
                      word_of(s.tracker, "arithmetic"),
                      s.cases.collapse ? word_of(s.tracker, "collapse") : "any",
                      s.oracles,
                      s.cases.arithmetic == Arithmetic::rounded ? s.tracker.jitter : 0};
  if (!s.corpus.empty())
    save_failures(summary, [&](std::uint64_t seed) { return make_case(seed, s.cases); },
                  {s.corpus, oracles, s.limits});
  return finish(summary, s.summary);
}

int replay(const Settings& s, const CLI::App& command) {
  const CheckChoice oracles(command.count("--oracles") == 0 ? "all" : s.oracles);
  int exit = kDone;
  for (const std::string& file : s.replay) {
    CorpusCase c = read_case(file);
    if (command.count("--arithmetic") != 0) c.fuzz_case.options.arithmetic = s.cases.arithmetic;
    const FuzzSummary run = run_in_child(c.fuzz_case, oracles, s.campaign.case_seconds);
    if (!run.failures.empty()) {
      exit = kNo;
      fmt::print("{}: {}: {}\n", file, run.failures[0].check, run.failures[0].cause);
    } else {
      fmt::print("{}: passes; {} remodels, {} changed the mesh{}\n", file, run.remodels,
                 run.surgeries, run.ended.empty() ? "" : "; ended by: " + run.ended.begin()->first);
    }
  }
  return exit;
}

int show(const Settings& s) {
  const std::string text = to_toml({make_case(s.show, s.cases), {}, {}});
  if (s.out.empty())
    fmt::print("{}", text);
  else
    write_file(s.out, text);
  return kDone;
}

int merge_files(const Settings& s) {
  if (s.out.empty()) throw InvalidInput("--merge needs -o FILE for the merged summary");
  FuzzSummary sum = read_summary(s.merge.front());
  for (std::size_t i = 1; i < s.merge.size(); ++i) merge(sum, read_summary(s.merge[i]));
  return finish(sum, s.out);
}

int fuzz(Settings s, const CLI::App& command) {
  s.cases.arithmetic = s.tracker.arithmetic;
  if (command.count("--collapse") != 0) s.cases.collapse = s.tracker.collapse;
  if (command.count("--jitter") != 0) s.cases.jitter = s.tracker.jitter;
  if (!s.merge.empty()) return merge_files(s);
  if (!s.replay.empty()) return replay(s, command);
  if (command.count("--show") != 0) return show(s);
  return run_cases(s);
}

void add_campaign_options(CLI::App& command, Settings& s) {
  command.add_option("--cases", s.campaign.cases, "Cases to run, from the first seed on")
      ->type_name("N");
  command.add_option("--seed", s.campaign.first, "The first seed")
      ->capture_default_str()
      ->type_name("S");
  command.add_option("--time", s.campaign.seconds, "Start no case after so many seconds")
      ->type_name("T");
  command
      .add_option("--jobs", s.campaign.jobs, "Worker processes; the results do not depend on it")
      ->capture_default_str()
      ->type_name("J");
  command
      .add_option("--case-seconds", s.campaign.case_seconds,
                  "Of a core; a case that takes longer hangs")
      ->capture_default_str()
      ->type_name("T");
  add_choice(command, "--profile", s.cases.profile, kProfileNames,
             "Cases: random, hostile, fed_back, or all (the default)");
  add_option_flags(command, tracker_options(), s.tracker,
                   {{"--arithmetic", "arithmetic"}, {"--jitter", "jitter"}});
  OptionInfo collapse = tracker_options().row("collapse").about;
  collapse.meaning += "; else the seed decides";
  collapse.usual.reset();
  add_option_flag(command, "--collapse", collapse, [&s](const Value& value) {
    set(s.tracker, tracker_options(), "collapse", value);
  });
  command
      .add_option("--oracles", s.oracles,
                  "sampled (fast ones always, others on one seed in 64), fast, all, or names")
      ->capture_default_str()
      ->type_name("O");
  command.add_option("--corpus", s.corpus, "Minimise failing cases and save them there")
      ->type_name("DIR");
  command.add_option("--minimise-seconds", s.limits.seconds, "At most so long on each of them")
      ->capture_default_str()
      ->type_name("T");
  command.add_option("--summary", s.summary, "Write the summary as JSON")->type_name("F.json");
}

}  // namespace

void add_fuzz(CLI::App& app, int& exit) {
  auto s = std::make_shared<Settings>();
  CLI::App* command = app.add_subcommand(
      "fuzz", "Try to break the tracker: seeded cases, watched by checks, failures minimised");
  add_campaign_options(*command, *s);
  auto* other = command->add_option_group("instead of a campaign")->require_option(0, 1);
  other->add_option("--replay", s->replay, "Run saved cases, by default under all checks")
      ->type_name("FILE");
  other->add_option("--show", s->show, "Print a seed's case, as it would be saved")
      ->type_name("SEED");
  other->add_option("--merge", s->merge, "Add up summaries of disjoint seeds; needs -o")
      ->type_name("F.json");
  command->add_option("-o,--output", s->out, "File for --show or --merge")->type_name("FILE");
  command->footer(
      "Exit codes: 0 no failure, 1 a check objected, a crash or a hang, 2 bad input. Refusals are "
      "failures unless the arithmetic is rounded, where they are only counted. papers/fuzz.md has "
      "the checks and the summary's fields.");
  command->callback([s, command, &exit] { exit = fuzz(*s, *command); });
}

}  // namespace suture::sims
