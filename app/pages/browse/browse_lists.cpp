// SPDX-License-Identifier: Apache-2.0
#include "app/pages/browse/browse_lists.hpp"

#include "app/pages/browse/photo_words.hpp"
#include "audio/sentences/sentences.hpp"

#include <QLocale>
#include <QVariantMap>

#include <string>
#include <utility>

namespace tp {

namespace {

constexpr std::size_t rows_at_once = 100;
constexpr std::size_t most_suggestions = 6;
constexpr std::size_t most_results = 50;

const char* kind_of(BrowseLists::Topic topic) {
    switch (topic) {
    case BrowseLists::Topic::People:
        return "person";
    case BrowseLists::Topic::Years:
        return "year";
    case BrowseLists::Topic::Places:
        return "place";
    case BrowseLists::Topic::Keywords:
        return "keyword";
    }
    return "";
}

} // namespace

BrowseLists::BrowseLists(BrowseAlbum& album, BrowseTrail& trail, BrowseDetails& details, BrowseTeller& teller,
                         TagPlayback& tags)
    : album_(album), trail_(trail), details_(details), teller_(teller), tags_(tags) {
    connect(&trail_, &BrowseTrail::album_changed, this, &BrowseLists::refresh);
}

// --- from level to level ---

void BrowseLists::allPhotos() {
    if (!trail_.ready_or_refuse())
        return;
    const std::optional<PhotoEntry> at = trail_.here();
    trail_.to_the_top();
    if (at && !trail_.go_to(*at))
        return;
    enter_level();
}

void BrowseLists::openTopic(Topic topic) {
    const QString title = topic == Topic::People   ? tr("People")
                          : topic == Topic::Years  ? tr("Years")
                          : topic == Topic::Places ? tr("Places")
                                                   : tr("Keywords");
    open_list({View::Names, title, {}, kind_of(topic), {}, -1});
}

void BrowseLists::openSearch() { open_list({View::Search, tr("Search"), {}, {}, {}, -1}); }

void BrowseLists::open_list(BrowseTrail::Level level) {
    if (!trail_.ready_or_refuse())
        return;
    tags_.stop();
    trail_.to_the_top();
    trail_.go_down(std::move(level));
    enter_level();
}

void BrowseLists::open_photos(const QString& title, PhotoTrail photos, const std::optional<PhotoEntry>& at) {
    if (const Result<bool> there = at ? photos.to(*at) : photos.to_first(); !there)
        return teller_.refuse(in_persons_language(there.error()));
    if (!photos.here())
        return teller_.refuse(tr("There are no photographs of that any more."));
    trail_.go_down({View::Photos, title, std::move(photos), {}, {}, -1});
    enter_level();
}

/// Shows and tells the last level, whether one came down to it or up.
void BrowseLists::enter_level() {
    most_rows_ = rows_at_once;
    if (trail_.view() == View::Photos) {
        rows_.clear();
        choices_.clear();
        emit trail_.levelChanged();
        emit rowsChanged();
        trail_.show_here();
        return teller_.tell(tr("%1, %2: %3", "list, place in it, summary")
                                .arg(trail_.title(), trail_.placeText(), details_.summary()));
    }
    fill();
    emit rowsChanged();
    tell();                     // to its end; then
    emit trail_.levelChanged(); // the row that the keyboard comes to
}

void BrowseLists::back() {
    if (trail_.at_the_top())
        return teller_.tell(Earcon::list_end,
                            tr("These are all the photographs; there is no list above them."));
    tags_.stop();
    teller_.sound(Earcon::previous);
    trail_.go_up();
    enter_level();
}

// --- rows ---

void BrowseLists::add_row(const QString& text, const QString& detail, Choice choice) {
    rows_ << QVariantMap{{QStringLiteral("text"), text}, {QStringLiteral("detail"), detail}};
    choices_.push_back(std::move(choice));
}

/// Says so only where they are others: a list that is made anew takes the keyboard off its row.
void BrowseLists::refresh() {
    if (trail_.view() == View::Photos)
        return;
    const QVariantList rows_before = rows_;
    const QString found_before = found_;
    fill();
    if (rows_ != rows_before || found_ != found_before)
        emit rowsChanged();
}

void BrowseLists::fill() {
    rows_.clear();
    choices_.clear();
    found_.clear();
    letters_.clear();
    if (trail_.view() == View::Search)
        list_matches();
    else if (trail_.level().kind == "year")
        list_years();
    else
        list_names();
}

void BrowseLists::list_years() {
    AlbumQueries queries = album_.open().queries();
    const auto years = queries.years();
    if (!years)
        return teller_.refuse(in_persons_language(years.error()));
    for (auto year = years->rbegin(); year != years->rend(); ++year) {
        const auto photos = queries.count_before(OfYear{*year}, {});
        add_row(QString::number(*year),
                photos ? tr("%n photograph(s)", nullptr, static_cast<int>(*photos)) : QString(), *year);
    }
    found_ = tr("%n year(s)", nullptr, static_cast<int>(years->size()));
}

void BrowseLists::list_names() {
    const std::string& kind = trail_.level().kind;
    auto topics = album_.open().queries().topics(kind, {}, most_rows_ + 1);
    if (!topics)
        return teller_.refuse(in_persons_language(topics.error()));
    const bool more = topics->size() > most_rows_;
    if (more)
        topics->pop_back();
    for (const TopicEntry& topic : *topics)
        add_row(QString::fromStdString(topic.name),
                tr("%n photograph(s)", nullptr, static_cast<int>(topic.photos)), topic);
    const int count = static_cast<int>(topics->size());
    found_ = kind == "person"  ? tr("%n person(s)", nullptr, count)
             : kind == "place" ? tr("%n place(s)", nullptr, count)
                               : tr("%n keyword(s)", nullptr, count);
    if (more) {
        found_ = tr("The first %1", "of a long list").arg(topics->size());
        add_row(tr("Show more"), {}, More{});
    }
}

void BrowseLists::list_matches() {
    const std::string typed_words = typed().toStdString();
    AlbumQueries queries = album_.open().queries();
    const auto topics = queries.suggestions(typed_words, most_suggestions);
    const auto photos = queries.search(typed_words, most_results);
    const auto letters = queries.next_letters(typed_words);
    if (!topics || !photos || !letters)
        return teller_.refuse(in_persons_language(!topics   ? topics.error()
                                                  : !photos ? photos.error()
                                                            : letters.error()));
    for (const std::string& letter : *letters)
        letters_ << QLocale().toUpper(QString::fromStdString(letter));
    for (const TopicEntry& topic : *topics) {
        const QString count = tr("%n photograph(s)", nullptr, static_cast<int>(topic.photos));
        add_row(QString::fromStdString(topic.name),
                topic.kind == "person"  ? tr("person, %1").arg(count)
                : topic.kind == "place" ? tr("place, %1").arg(count)
                                        : tr("keyword, %1").arg(count),
                topic);
    }
    const PhotoWords say = trail_.words();
    for (const PhotoEntry& photo : *photos)
        if (const auto known = queries.summary(photo.id); known && *known)
            add_row(say.summary(photo.path, (*known)->record, (*known)->seen),
                    QString::fromStdString(photo.path.filename().string()), photo);
    if (typed().trimmed().isEmpty())
        return;
    found_ = photos->size() == most_results
                 ? tr("%n photograph(s) or more", nullptr, static_cast<int>(photos->size()))
                 : tr("%n photograph(s)", nullptr, static_cast<int>(photos->size()));
    if (!topics->empty())
        found_ = tr("%1, %2", "two counts")
                     .arg(found_, tr("%n suggestion(s)", nullptr, static_cast<int>(topics->size())));
}

void BrowseLists::reach(int row) {
    if (row < 0 || row >= rows_.size() || !teller_.narrator().voice_on())
        return; // a screen reader says what the keyboard is on by itself
    const QVariantMap one = rows_.at(row).toMap();
    const QString detail = one.value(QStringLiteral("detail")).toString();
    const QString text = one.value(QStringLiteral("text")).toString();
    const QString told =
        detail.isEmpty() ? text : tr("%1, %2", "a row and what belongs to it").arg(text, detail);
    if (told != teller_.narrator().sentence()) // the keyboard came back to it
        teller_.tell(told);
}

void BrowseLists::choose(int row) {
    if (row < 0 || row >= static_cast<int>(choices_.size()))
        return teller_.refuse(tr("Go to a row first."));
    const Choice choice = choices_[static_cast<std::size_t>(row)];
    trail_.level().chosen_row = row;
    teller_.sound(Earcon::next);
    AlbumIndex& index = album_.open().index();
    if (const auto* const topic = std::get_if<TopicEntry>(&choice)) {
        open_photos(QString::fromStdString(topic->name), PhotoTrail(index, OfTopic{topic->kind, topic->name}),
                    {});
    } else if (const int* const year = std::get_if<int>(&choice)) {
        open_photos(QString::number(*year), PhotoTrail(index, OfYear{*year}), {});
    } else if (const auto* const photo = std::get_if<PhotoEntry>(&choice)) {
        PhotoTrail::Found results;
        for (const Choice& one : choices_)
            if (const auto* const result = std::get_if<PhotoEntry>(&one))
                results.push_back(*result);
        open_photos(tr("Found: %1", "a search").arg(typed()), PhotoTrail(index, std::move(results)), *photo);
    } else {
        most_rows_ += rows_at_once;
        refresh();
        tell();
    }
}

// --- the search ---

void BrowseLists::type(const QString& words) {
    if (trail_.view() != View::Search || words == typed())
        return;
    trail_.level().typed = words;
    trail_.level().chosen_row = -1;
    fill();
    emit rowsChanged();
}

void BrowseLists::tellFound() {
    if (trail_.view() == View::Search && !found_.isEmpty())
        teller_.tell(tr("%1.", "what was found").arg(found_));
}

void BrowseLists::reachLetter(int letter) {
    if (letter >= 0 && letter < letters_.size())
        teller_.tell(letters_[letter]);
}

void BrowseLists::addLetter(int letter) {
    if (letter >= 0 && letter < letters_.size())
        spell(typed() + (typed().isEmpty() ? letters_[letter] : QLocale().toLower(letters_[letter])));
}

void BrowseLists::takeLetterBack() {
    if (typed().isEmpty())
        return teller_.refuse(tr("There is no letter to delete."));
    QString left = typed();
    left.chop(left.back().isLowSurrogate() ? 2 : 1);
    spell(left);
}

void BrowseLists::spell(const QString& words) {
    teller_.sound(Earcon::next);
    type(words);
    teller_.tell(found_.isEmpty() ? tr("The search field is empty.")
                                  : tr("%1: %2.", "what is typed, what was found").arg(words, found_));
}

// --- what the list is ---

void BrowseLists::tell() {
    teller_.narrator().stop(); // an older list is of no interest
    teller_.tell(words(), Priority::message);
}

QString BrowseLists::words() const {
    if (trail_.view() == View::Search)
        return found_.isEmpty() ? tr("Search. Type a name, a place or a word, or move a finger over the "
                                     "letters and lift it on one. "
                                     "The arrow keys go through what is found.")
                                : tr("Search for %1: %2.").arg(typed(), found_);
    if (rows_.isEmpty())
        return tr("%1: there are none yet.", "a list").arg(trail_.title());
    return tr("%1: %2. Choose one with the arrow keys and Enter.", "a list, how many")
        .arg(trail_.title(), found_);
}

} // namespace tp
