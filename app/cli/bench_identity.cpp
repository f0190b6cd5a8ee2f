// SPDX-License-Identifier: Apache-2.0
#include "app/cli/bench_identity.hpp"

#include "app/cli/command_line.hpp"
#include "app/cli/long_work.hpp"
#include "app/cli/photographs_in.hpp"
#include "app/cli/terminal.hpp"
#include "app/figures/bench/identity_bench.hpp"

#include <QString>

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace tp {

namespace {

constexpr std::size_t many_faces = 20'000, some_people = 200;

void show(const std::vector<IdentityRow>& rows) {
    const auto column = [](const std::string& words) { // by letters, not bytes: ‰ and °
        return QString::fromStdString(words).leftJustified(24).toStdString();
    };
    print("%-24s %9s %5s %5s %8s %9s %7s %8s %9s %7s\n", "made harder", "portraits", "found", "unfit",
          "one's", "another's", "equal %", "accept %", "within", "both %");
    for (const IdentityRow& row : rows)
        print("%s %9d %5d %5d %8.3f %9.3f %7.2f %8.1f %9.3f %7.2f\n", column(row.how).c_str(), row.portraits,
              row.found, row.unfit, row.genuine, row.impostor, row.equal_error_percent,
              row.true_accepts_percent, row.threshold, row.both_equal_error_percent);
    std::puts(
        "\nmean distances of one person's portraits and of different people's, the first of each as it is, "
        "the\n"
        "others made harder; equal error; pairs of one person accepted where one in a thousand others is, "
        "and\n"
        "within which distance that is; equal error where both are made harder. Unfit faces count too.");
}

} // namespace

int bench_identity(const VerbLine& line) {
    const auto photographs = photographs_in(line.text("identity").toStdString());
    if (!photographs)
        return refused(photographs.error());
    if (const std::string problem = line.make_folder("out"); !problem.empty())
        return refused(problem);
    const auto bench = run_identity_bench(photographs->files, say_step, LongWork::stop_asked());
    if (!bench)
        return refused(bench.error());
    const std::vector<IdentityRow> rows = identity_rows(bench->portraits);
    const std::filesystem::path out = line.text("out").toStdString();
    for (const auto& written : {write_identity_table(out, rows), plot_identity(out, bench->portraits)})
        if (!written)
            return refused(written.error());
    show(rows);
    const IdentityGroups groups = identity_groups(bench->portraits);
    print("\ngroups of the portraits as they are: %d of %d people in %d faces (%.3f a person), purity %.4f\n",
          groups.groups, groups.people, groups.faces, groups.groups_a_person(), groups.purity);
    say_step("adding faces to many");
    print("ms a face: described in %.1f; added to %zu of %zu people in %.3f, to %zu of as many in %.3f\n",
          bench->describe_ms, many_faces, some_people, face_adding_ms(many_faces, some_people), many_faces,
          face_adding_ms(many_faces, many_faces));
    return exit_done;
}

} // namespace tp
