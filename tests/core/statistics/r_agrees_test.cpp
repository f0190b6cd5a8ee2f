// SPDX-License-Identifier: Apache-2.0
// The same numbers by R, to six digits: aov and anova.mlm, TukeyHSD, ptukey.
#include "core/statistics/pairwise.hpp"
#include "core/statistics/repeated_anova.hpp"
#include "core/statistics/studentized_range.hpp"
#include "test_program.hpp"

#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QStringList>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace r_agrees_test {

using namespace tp;

namespace {

constexpr double digits = 1e-6;

/// What a script prints, number by number.
std::vector<double> by_r(const QString& script, const QStringList& arguments) {
    QProcess process;
    process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    process.start("Rscript", QStringList{"--vanilla", "-e", script} + arguments);
    process.waitForFinished(-1);
    std::vector<double> numbers;
    for (const QString& word :
         QString(process.readAllStandardOutput()).split(QRegularExpression("\\s+"), Qt::SkipEmptyParts))
        numbers.push_back(word.toDouble());
    return numbers;
}

/// People who differ, in a design of three by four, with effects of every kind.
WithinMeans people(std::size_t count, unsigned seed) {
    WithinMeans means;
    means.factors = {{"a", {"1", "2", "3"}}, {"b", {"1", "2", "3", "4"}}};
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 1.0);
    for (std::size_t i = 0; i < count; ++i) {
        means.participants.push_back(std::to_string(i + 1));
        const double own = 10.0 + 2.0 * noise(random), slope = 0.5 * noise(random);
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 4; ++b)
                means.values.push_back(own + (0.6 + slope) * a + 0.1 * b * b * (a == 2 ? 1.5 : 1.0) +
                                       0.7 * noise(random));
    }
    return means;
}

void write(const WithinMeans& means, const QString& file) {
    QByteArray text("id,a,b,y\n");
    for (std::size_t i = 0; i < means.participants.size(); ++i)
        for (std::size_t cell = 0; cell < means.cells(); ++cell)
            text += QString("%1,%2,%3,%4\n")
                        .arg(i + 1)
                        .arg(cell / 4 + 1)
                        .arg(cell % 4 + 1)
                        .arg(means.of(i)[cell], 0, 'g', 17)
                        .toUtf8();
    QFile out(file);
    QVERIFY(out.open(QIODevice::WriteOnly) && out.write(text) == text.size());
}

constexpr const char* analysis = R"r(
d <- read.csv(commandArgs(TRUE)[1])
for (f in c("id", "a", "b")) d[[f]] <- factor(d[[f]])
s <- summary(aov(y ~ a * b + Error(id / (a * b)), d))
wide <- reshape(transform(d, cell = interaction(b, a, lex.order = FALSE))[c("id", "cell", "y")],
                idvar = "id", timevar = "cell", direction = "wide")
cells <- expand.grid(b = factor(1:4), a = factor(1:3))
m <- lm(as.matrix(wide[paste0("y.", cells$b, ".", cells$a)]) ~ 1)
spherical <- list(anova(m, M = ~a, X = ~1, idata = cells, test = "Spherical"),
                  anova(m, M = ~a + b, X = ~a, idata = cells, test = "Spherical"),
                  anova(m, M = ~a * b, X = ~a + b, idata = cells, test = "Spherical"))
people <- s[["Error: id"]][[1]][1, "Sum Sq"]
errors <- people
for (e in c("a", "b", "a:b")) errors <- errors + s[[paste0("Error: id:", e)]][[1]][2, "Sum Sq"]
for (i in 1:3) {
    t <- s[[paste0("Error: id:", c("a", "b", "a:b")[i])]][[1]]
    cat(sprintf("%.15g ", c(t[1, "F value"], t[1, "Pr(>F)"], spherical[[i]][1, "G-G Pr"],
                            t[1, "Sum Sq"] / (t[1, "Sum Sq"] + errors))))
}
for (f in c("a", "b")) {
    alone <- aggregate(reformulate(c("id", f), "y"), d, mean)
    cat(sprintf("%.15g ", TukeyHSD(aov(reformulate(c("id", f), "y"), alone), f)[[f]][, "p adj"]))
}
)r";

} // namespace

class RAgreesTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        if (QStandardPaths::findExecutable("Rscript").isEmpty())
            QSKIP("Rscript is missing (package r-base-core)");
    }
    void analysis_of_variance_and_tukey_data() {
        QTest::addColumn<int>("participants");
        QTest::addColumn<unsigned>("seed");
        QTest::newRow("ten people") << 10 << 1U;
        QTest::newRow("fewer people than contrasts") << 5 << 2U;
        QTest::newRow("two people") << 2 << 3U;
        QTest::newRow("forty people") << 40 << 4U;
    }
    void analysis_of_variance_and_tukey() {
        QFETCH(int, participants);
        QFETCH(unsigned, seed);
        const QTemporaryDir folder;
        const WithinMeans means = people(static_cast<std::size_t>(participants), seed);
        write(means, folder.filePath("trials.csv"));
        const std::vector<double> theirs = by_r(analysis, {folder.filePath("trials.csv")});

        std::vector<double> ours;
        for (const WithinEffect& effect : repeated_anova(means).effects)
            ours.insert(ours.end(), {*effect.f, *effect.p, *effect.p_spherical, *effect.eta_squared});
        for (const std::size_t factor : {0U, 1U})
            for (const LevelPair& pair : tukey_hsd(means, factor).pairs)
                ours.push_back(pair.p);
        QCOMPARE(theirs.size(), ours.size());
        for (std::size_t i = 0; i < ours.size();
             ++i) // R's own p of Tukey's is exact to 1e-10 or so, not relatively
            QVERIFY2(std::abs(ours[i] - theirs[i]) <= digits * std::abs(theirs[i]) + 1e-10,
                     qPrintable(QString("number %1: %2, by R %3")
                                    .arg(i)
                                    .arg(ours[i], 0, 'g', 12)
                                    .arg(theirs[i], 0, 'g', 12)));
    }
    /// From ten degrees of freedom on: with two, R is 0.15 % off where the answer is elementary (studentized_range_test.cpp).
    void studentized_range() {
        const std::vector<double> theirs =
            by_r("for (k in c(2, 3, 5, 10, 25)) for (df in c(10, 18, 36, 200)) for (q in c(0.5, 2, 3.5, 6)) "
                 "cat(sprintf('%.15g ', ptukey(q, k, df, lower.tail = FALSE)))",
                 {});
        std::size_t i = 0;
        for (const int means : {2, 3, 5, 10, 25})
            for (const double df : {10.0, 18.0, 36.0, 200.0})
                for (const double q : {0.5, 2.0, 3.5, 6.0}) {
                    QVERIFY(i < theirs.size());
                    const double here = studentized_range_above(q, means, df);
                    QVERIFY2(std::abs(here - theirs[i]) <= digits * theirs[i] + 1e-10,
                             qPrintable(QString("%1 means, %2, %3: %4, by R %5")
                                            .arg(means)
                                            .arg(df)
                                            .arg(q)
                                            .arg(here, 0, 'g', 12)
                                            .arg(theirs[i], 0, 'g', 12)));
                    ++i;
                }
        QCOMPARE(theirs.size(), i);
    }
};

} // namespace r_agrees_test

TP_TEST(r_agrees_test, RAgreesTest, nothing)
#include "r_agrees_test.moc"
