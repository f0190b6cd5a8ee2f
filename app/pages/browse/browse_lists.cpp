// SPDX-License-Identifier: Apache-2.0
// The levels of BrowseSession: lists of names, years, places and keywords, and the search.
#include "app/pages/browse/browse_session.hpp"

#include "audio/sentences/sentences.hpp"

#include <QLocale>
#include <QVariantMap>

#include <algorithm>
#include <utility>

namespace tp {

namespace {

constexpr std::size_t rows_at_once = 100;
constexpr std::size_t most_suggestions = 6;
constexpr std::size_t most_results = 50;

const char* kind_of(BrowseSession::Topic topic) {
    switch (topic) {
    case BrowseSession::Topic::People:
        return "person";
    case BrowseSession::Topic::Years:
        return "year";
    case BrowseSession::Topic::Places:
        return "place";
    case BrowseSession::Topic::Keywords:
        return "keyword";
    }
    return "";
}

} // namespace

QString BrowseSession::title_of(const std::string& kind) const {
    return kind == "person"  ? tr("People")
           : kind == "year"  ? tr("Years")
           : kind == "place" ? tr("Places")
                             : tr("Keywords");
}

void BrowseSession::allPhotos() {
    if (state_ != State::Ready)
        return refuse(emptyText());
    const std::optional<PhotoEntry> at = trail().here();
    levels_.resize(1);
    if (at && !checked(trail().to(*at)))
        return;
    enter_level();
}

void BrowseSession::openTopic(Topic topic) {
    if (state_ != State::Ready)
        return refuse(emptyText());
    playback_.stop();
    levels_.resize(1);
    const std::string kind = kind_of(topic);
    levels_.push_back({View::Names, title_of(kind), {}, kind, {}, -1});
    enter_level();
}

void BrowseSession::openSearch() {
    if (state_ != State::Ready)
        return refuse(emptyText());
    playback_.stop();
    levels_.resize(1);
    levels_.push_back({View::Search, tr("Search"), {}, {}, {}, -1});
    enter_level();
}

void BrowseSession::open_photos(const QString& title, PhotoTrail trail, const std::optional<PhotoEntry>& at) {
    if (const Result<bool> there = at ? trail.to(*at) : trail.to_first(); !there)
        return refuse(in_persons_language(there.error()));
    if (!trail.here())
        return refuse(tr("There is no photograph of that any more."));
    levels_.push_back({View::Photos, title, std::move(trail), {}, {}, -1});
    enter_level();
}

/// Shows and tells the last level, whether one came down to it or up.
void BrowseSession::enter_level() {
    most_rows_ = rows_at_once;
    if (view() == View::Photos) {
        rows_.clear();
        choices_.clear();
        emit levelChanged();
        emit rowsChanged();
        show_here();
        narrator_.tell(tr("%1, %2: %3", "list, place in it, summary").arg(title(), placeText(), summary_),
                       Priority::touch);
        return;
    }
    fill_rows();
    emit rowsChanged();
    tell_list();         // to its end; then
    emit levelChanged(); // the row that the keyboard comes to
}

void BrowseSession::back() {
    if (levels_.size() == 1) {
        earcons_.play(Earcon::list_end);
        narrator_.tell(tr("These are all photographs; there is no list above them."), Priority::touch);
        return;
    }
    playback_.stop();
    earcons_.play(Earcon::previous);
    levels_.pop_back();
    enter_level();
}

// --- rows ---

void BrowseSession::add_row(const QString& text, const QString& detail, Choice choice) {
    rows_ << QVariantMap{{QStringLiteral("text"), text}, {QStringLiteral("detail"), detail}};
    choices_.push_back(std::move(choice));
}

/// Says so only where they are others: a list that is made anew takes the keyboard off its row.
void BrowseSession::list_rows() {
    const QVariantList rows_before = rows_;
    const QString found_before = found_;
    fill_rows();
    if (rows_ != rows_before || found_ != found_before)
        emit rowsChanged();
}

void BrowseSession::fill_rows() {
    rows_.clear();
    choices_.clear();
    found_.clear();
    letters_.clear();
    if (view() == View::Names)
        list_names(most_rows_);
    else if (view() == View::Search)
        list_matches();
}

void BrowseSession::list_names(std::size_t most) {
    AlbumQueries queries = album_.queries();
    if (level().kind == "year") {
        const auto years = queries.years();
        if (!years)
            return refuse(in_persons_language(years.error()));
        for (auto year = years->rbegin(); year != years->rend(); ++year) {
            const auto photos = queries.count_before(OfYear{*year}, {});
            add_row(QString::number(*year),
                    photos ? tr("%n photograph(s)", nullptr, static_cast<int>(*photos)) : QString(), *year);
        }
        found_ = tr("%n year(s)", nullptr, static_cast<int>(years->size()));
        return;
    }
    auto topics = queries.topics(level().kind, {}, most + 1);
    if (!topics)
        return refuse(in_persons_language(topics.error()));
    const bool more = topics->size() > most;
    if (more)
        topics->pop_back();
    for (const TopicEntry& topic : *topics)
        add_row(QString::fromStdString(topic.name),
                tr("%n photograph(s)", nullptr, static_cast<int>(topic.photos)), topic);
    found_ = level().kind == "person"  ? tr("%n person(s)", nullptr, static_cast<int>(topics->size()))
             : level().kind == "place" ? tr("%n place(s)", nullptr, static_cast<int>(topics->size()))
                                       : tr("%n keyword(s)", nullptr, static_cast<int>(topics->size()));
    if (more) {
        found_ = tr("The first %1", "of a long list").arg(topics->size());
        add_row(tr("Show more"), {}, More{});
    }
}

QString BrowseSession::topic_words(const TopicEntry& topic) const {
    const QString photos = tr("%n photograph(s)", nullptr, static_cast<int>(topic.photos));
    return topic.kind == "person"  ? tr("person, %1").arg(photos)
           : topic.kind == "place" ? tr("place, %1").arg(photos)
                                   : tr("keyword, %1").arg(photos);
}

void BrowseSession::list_matches() {
    const std::string words = level().typed.toStdString();
    AlbumQueries queries = album_.queries();
    const auto topics = queries.suggestions(words, most_suggestions);
    const auto photos = queries.search(words, most_results);
    const auto letters = queries.next_letters(words);
    if (!topics || !photos || !letters)
        return refuse(
            in_persons_language(!topics ? topics.error() : !photos ? photos.error() : letters.error()));
    for (const std::string& letter : *letters)
        letters_ << QLocale().toUpper(QString::fromStdString(letter));
    for (const TopicEntry& topic : *topics)
        add_row(QString::fromStdString(topic.name), topic_words(topic), topic);
    const PhotoWords say;
    for (const PhotoEntry& photo : *photos)
        if (const auto known = queries.summary(photo.id); known && *known)
            add_row(say.summary(photo.path, (*known)->record),
                    QString::fromStdString(photo.path.filename().string()), photo);
    if (level().typed.trimmed().isEmpty())
        return;
    found_ = photos->size() == most_results
                 ? tr("%n photograph(s) or more", nullptr, static_cast<int>(photos->size()))
                 : tr("%n photograph(s)", nullptr, static_cast<int>(photos->size()));
    if (!topics->empty())
        found_ = tr("%1, %2", "two counts")
                     .arg(found_, tr("%n suggestion(s)", nullptr, static_cast<int>(topics->size())));
}

void BrowseSession::type(const QString& words) {
    if (view() != View::Search || words == level().typed)
        return;
    level().typed = words;
    level().chosen_row = -1;
    fill_rows();
    emit rowsChanged();
}

void BrowseSession::tellFound() {
    if (view() == View::Search && !found_.isEmpty())
        narrator_.tell(tr("%1.", "what was found").arg(found_), Priority::touch);
}

void BrowseSession::reachLetter(int letter) {
    if (letter >= 0 && letter < letters_.size())
        narrator_.tell(letters_[letter], Priority::touch);
}

void BrowseSession::addLetter(int letter) {
    if (letter >= 0 && letter < letters_.size())
        spell(typed() + (typed().isEmpty() ? letters_[letter] : QLocale().toLower(letters_[letter])));
}

void BrowseSession::takeLetterBack() {
    if (typed().isEmpty())
        return refuse(tr("There is no letter to take away."));
    QString words = typed();
    words.chop(words.back().isLowSurrogate() ? 2 : 1);
    spell(words);
}

void BrowseSession::spell(const QString& words) {
    earcons_.play(Earcon::next);
    type(words);
    narrator_.tell(found_.isEmpty() ? tr("Nothing is typed any more.") : tr("%1: %2.", "what is typed, what was found").arg(words, found_),
                   Priority::touch);
}

void BrowseSession::tell_list() {
    narrator_.stop(); // an older list is of no interest
    narrator_.tell(list_words(), Priority::message);
}

QString BrowseSession::list_words() const {
    if (view() == View::Search)
        return found_.isEmpty()
                   ? tr("Search. Type a name, a place or a word, or move a finger over the letters and lift it on one. "
                        "The arrow keys go through what is found.")
                   : tr("Search for %1: %2.").arg(typed(), found_);
    if (rows_.isEmpty())
        return tr("%1: there are none yet.", "a list").arg(title());
    return tr("%1: %2. Choose one with the arrow keys and Return.", "a list, how many").arg(title(), found_);
}

void BrowseSession::reach(int row) {
    if (row < 0 || row >= rows_.size() || !narrator_.voice_on())
        return; // a screen reader says what the keyboard is on by itself
    const QVariantMap one = rows_.at(row).toMap();
    const QString detail = one.value(QStringLiteral("detail")).toString();
    const QString text = one.value(QStringLiteral("text")).toString();
    const QString words =
        detail.isEmpty() ? text : tr("%1, %2", "a row and what belongs to it").arg(text, detail);
    if (words != narrator_.sentence()) // the keyboard came back to it
        narrator_.tell(words, Priority::touch);
}

void BrowseSession::choose(int row) {
    if (row < 0 || row >= static_cast<int>(choices_.size()))
        return refuse(tr("Go to a row first."));
    const Choice choice = choices_[static_cast<std::size_t>(row)];
    level().chosen_row = row;
    earcons_.play(Earcon::next);
    AlbumIndex& index = album_.index();
    if (const auto* const topic = std::get_if<TopicEntry>(&choice)) {
        open_photos(QString::fromStdString(topic->name), PhotoTrail(index, OfTopic{topic->kind, topic->name}),
                    {});
    } else if (const int* const year = std::get_if<int>(&choice)) {
        open_photos(QString::number(*year), PhotoTrail(index, OfYear{*year}), {});
    } else if (const auto* const photo = std::get_if<PhotoEntry>(&choice)) {
        PhotoTrail::Found found;
        for (const Choice& one : choices_)
            if (const auto* const result = std::get_if<PhotoEntry>(&one))
                found.push_back(*result);
        open_photos(tr("Found: %1", "a search").arg(typed()), PhotoTrail(index, std::move(found)), *photo);
    } else {
        most_rows_ += rows_at_once;
        list_rows();
        tell_list();
    }
}

} // namespace tp
