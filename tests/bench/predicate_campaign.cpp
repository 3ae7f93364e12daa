// Millions of near-degenerate decisions and positions against GMP: how many are wrong, by family.
// Exits with 1 if one is wrong of an arithmetic that promises to be right.
#include <fmt/core.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <ctime>
#include <functional>
#include <mutex>
#include <thread>

#include "kernel/files.h"
#include "surgery/model/option_table.h"
#include "tests/brute/construct_questions.h"

using namespace suture;
using namespace suture::brute;

namespace {

constexpr int kCasesAChunk = 5'000;  // one generator each: so results do not depend on the jobs

struct Options {
  std::uint64_t cases = 1'000'000, seed = 1;
  unsigned jobs = 1;
  std::string output;
};

/// A row is of one question, arithmetic and family.
struct Row {
  std::string question, arithmetic, family;
  std::uint64_t cases = 0, filter_failures = 0;
  std::uint64_t wrong = 0;    ///< another sign than GMP's; not the double nearest to GMP's number
  std::uint64_t zero = 0;     ///< of these, signs: 0 where there is a side
  std::uint64_t far_off = 0;  ///< of these, positions: not within four doubles of the right one
  double seconds = 0, exact_seconds = 0;  ///< of the processor
  std::string first_wrong = {};
  bool promises_exactness = true, is_sign = true;
};

/// One chunk adds these to a table: the same rows in the same order for every chunk of a subject.
using Rows = std::vector<Row>;

/// A question and a family: asked in chunks.
struct Subject {
  std::function<Rows(Draws&, int cases)> ask;
  Rows rows;
};

double processor_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Function>
double seconds_of(const Function& function) {
  const double start = processor_seconds();
  function();
  return processor_seconds() - start;
}

Row judged(Row row, const std::vector<int>& signs, const std::vector<int>& right,
           const std::vector<SignQuestion>& questions) {
  for (std::size_t i = 0; i < signs.size(); ++i) {
    if (signs[i] == right[i]) continue;
    row.zero += signs[i] == 0 ? 1 : 0;
    if (row.wrong++ == 0)
      row.first_wrong = fmt::format("{} is not {}: {}", signs[i], right[i], show(questions[i]));
  }
  return row;
}

Rows sign_rows(Decision decision, Family family, Draws& random, int cases) {
  std::vector<SignQuestion> questions;
  for (int i = 0; i < cases; ++i) questions.push_back(sign_question(decision, family, random));
  std::vector<int> right(questions.size()), signs(questions.size());
  const auto answer = [&](const Oracle& oracle, std::vector<int>& to) {
    return seconds_of([&] {
      for (std::size_t i = 0; i < questions.size(); ++i) to[i] = ask(oracle, questions[i]);
    });
  };
  const double exact_seconds = answer(*make_rational_oracle(), right);
  Rows rows;
  for (const auto& [name, arithmetic] : kArithmeticNames) {
    if (arithmetic == Arithmetic::rational) continue;
    const auto oracle = make_oracle(arithmetic);
    Row row{name_of(decision), std::string(name), name_of(family), questions.size()};
    const OracleTally tally;
    row.seconds = answer(*oracle, signs);
    row.exact_seconds = exact_seconds;
    row.filter_failures = tally.counts().filter_failures;
    row.promises_exactness = arithmetic != Arithmetic::rounded;
    rows.push_back(judged(row, signs, right, questions));
  }
  return rows;
}

bool far_apart(double x, double right) {
  return !(nudged(right, -4) <= x && x <= nudged(right, 4));
}

/// The positions that `make` asks for, where there is one. Those of plain doubles are compared with
/// the others, which GMP has judged.
template <class Make>
Rows position_rows(const char* question, const std::string& family, const Make& make, int cases) {
  std::vector<decltype(make())> questions;
  while (questions.size() < static_cast<std::size_t>(cases))
    if (const auto drawn = make(); crosses(drawn)) questions.push_back(drawn);
  std::vector<double> right(questions.size()), plain(questions.size());
  Row exact{question, "filtered", family, questions.size()};
  exact.is_sign = false;
  Row rounded = exact;
  rounded.arithmetic = "rounded";
  rounded.promises_exactness = false;
  exact.seconds = seconds_of([&] {
    for (std::size_t i = 0; i < right.size(); ++i) right[i] = ask(questions[i]);
  });
  rounded.seconds = seconds_of([&] {
    for (std::size_t i = 0; i < plain.size(); ++i) plain[i] = ask_rounded(questions[i]);
  });
  exact.exact_seconds = rounded.exact_seconds = seconds_of([&] {
    for (std::size_t i = 0; i < right.size(); ++i) {
      const std::string text = mistake(questions[i], right[i]);
      if (!text.empty() && exact.wrong++ == 0) exact.first_wrong = text;
    }
  });
  for (std::size_t i = 0; i < right.size(); ++i) {
    if (plain[i] == right[i]) continue;
    ++rounded.wrong;
    rounded.far_off += far_apart(plain[i], right[i]) ? 1 : 0;
  }
  return {rounded, exact};
}

std::vector<Subject> subjects() {
  std::vector<Subject> all;
  for (const Decision decision : kDecisions)
    for (const Family family : kFamilies)
      all.push_back(
          {[=](Draws& random, int cases) { return sign_rows(decision, family, random, cases); },
           {}});
  const auto positions = [&](const char* question, const std::string& family, auto make) {
    all.push_back({[=](Draws& random, int cases) {
                     return position_rows(
                         question, family, [&] { return make(random); }, cases);
                   },
                   {}});
  };
  for (const Family family : kFamilies)
    positions("on_edge", name_of(family), [=](Draws& r) { return edge_question(family, r); });
  positions("on_edge", "halfway", edge_near_halfway);
  for (const Family family : kFamilies)
    positions("on_triangle", name_of(family),
              [=](Draws& r) { return triangle_question(family, r); });
  positions("on_triangle", "halfway", triangle_near_halfway);
  return all;
}

void add(Rows& to, const Rows& chunk) {
  if (to.empty()) {
    to = chunk;
    return;
  }
  for (std::size_t i = 0; i < to.size(); ++i) {
    if (to[i].wrong == 0) to[i].first_wrong = chunk[i].first_wrong;
    to[i].cases += chunk[i].cases;
    to[i].filter_failures += chunk[i].filter_failures;
    to[i].wrong += chunk[i].wrong;
    to[i].zero += chunk[i].zero;
    to[i].far_off += chunk[i].far_off;
    to[i].seconds += chunk[i].seconds;
    to[i].exact_seconds += chunk[i].exact_seconds;
  }
}

void show_progress(std::uint64_t chunks_done, std::uint64_t chunks) {
  if (!isatty(2)) return;
  fmt::print(stderr, "\r{} of {} cases", chunks_done * kCasesAChunk, chunks * kCasesAChunk);
  if (chunks_done == chunks) fmt::print(stderr, "\n");
}

/// Every subject gets as many whole chunks, at least one. Which counts come out depends on the
/// seed alone; which of several wrong cases is shown first may depend on the jobs.
void run(std::vector<Subject>& all, const Options& options) {
  const std::uint64_t share = kCasesAChunk * all.size();
  const std::uint64_t chunks = (options.cases + share - 1) / share * all.size();
  std::atomic<std::uint64_t> next{0};
  std::mutex guard;
  std::uint64_t done = 0;
  const auto work = [&] {
    for (std::uint64_t chunk = next++; chunk < chunks; chunk = next++) {
      Random seeds(options.seed);
      Draws random(seeds.next() ^ Random(chunk).next());
      Subject& subject = all[chunk % all.size()];
      const Rows rows = subject.ask(random, kCasesAChunk);
      const std::lock_guard lock(guard);
      add(subject.rows, rows);
      show_progress(++done, chunks);
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 1; i < options.jobs; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
}

std::string csv(const std::vector<Subject>& all) {
  std::string text =
      "question,arithmetic,family,cases,filter_failures,wrong,of_these_zero,of_these_far_off,"
      "ns_a_call,ns_a_call_of_gmp\n";
  const auto where = [](bool known, std::uint64_t count) {
    return known ? std::to_string(count) : std::string();
  };
  for (const Subject& subject : all)
    for (const Row& row : subject.rows)
      text += fmt::format("{},{},{},{},{},{},{},{},{:.0f},{:.0f}\n", row.question, row.arithmetic,
                          row.family, row.cases, where(row.is_sign, row.filter_failures), row.wrong,
                          where(row.is_sign, row.zero), where(!row.is_sign, row.far_off),
                          1e9 * row.seconds / static_cast<double>(row.cases),
                          1e9 * row.exact_seconds / static_cast<double>(row.cases));
  return text;
}

/// How many of those are wrong that must not be; each row's first is printed.
std::uint64_t broken_promises(const std::vector<Subject>& all) {
  std::uint64_t broken = 0;
  for (const Subject& subject : all)
    for (const Row& row : subject.rows) {
      if (!row.promises_exactness || row.wrong == 0) continue;
      fmt::print(stderr, "wrong: {}, {}: {}\n", row.arithmetic, row.family, row.first_wrong);
      broken += row.wrong;
    }
  return broken;
}

void summarize(const std::vector<Subject>& all) {
  std::uint64_t signs = 0, positions = 0;
  double seconds = 0;
  for (const Subject& subject : all) {
    const Row& row = subject.rows.front();
    (row.is_sign ? signs : positions) += row.cases;
    seconds += row.exact_seconds;
    for (const Row& each : subject.rows) seconds += each.seconds;
  }
  fmt::print("{} signs and {} positions against GMP in {:.0f} s of processor time\n", signs,
             positions, seconds);
}

}  // namespace

int main(int count, char** arguments) {
  Options options;
  CLI::App app("Near-degenerate decisions and positions against GMP");
  app.add_option("--cases", options.cases, "how many, over all questions and families")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000'000}));
  app.add_option("--seed", options.seed, "same seed, same cases");
  app.add_option("--jobs", options.jobs, "threads")->check(CLI::Range(1, 1024));
  app.add_option("-o,--output", options.output, "the table as CSV; without it, standard output");
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    std::vector<Subject> all = subjects();
    run(all, options);
    options.output.empty() ? fmt::print("{}", csv(all)) : write_file(options.output, csv(all));
    summarize(all);
    return broken_promises(all) == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "predicate_campaign: {}\n", error.what());
    return 2;
  }
}
