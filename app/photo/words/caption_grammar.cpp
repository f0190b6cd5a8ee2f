// SPDX-License-Identifier: Apache-2.0
#include "app/photo/words/caption_grammar.hpp"

#include <QStringList>

#include <algorithm>

namespace tp {

namespace {

/// More people than that are not told one by one: those with names are, and how many there are.
constexpr std::size_t most_told = 6;

QString one_after_another(QStringList parts) {
    parts.removeAll(QString());
    return parts.join(QStringLiteral(", "));
}

template <std::size_t count, typename Kind>
QString word(const std::array<const char*, count>& words, Kind kind) {
    return QString::fromUtf8(words[static_cast<std::size_t>(kind)]);
}

} // namespace

QString CaptionGrammar::people_in_short(const PhotoView& view) const {
    QStringList who;
    std::size_t unnamed = 0;
    for (const PersonShown& person : view.people) {
        if (person.name.isEmpty())
            ++unnamed;
        else
            who << person.name;
    }
    who << view.elsewhere; // they are among those without a name, as far as there are some
    unnamed -= std::min(unnamed, static_cast<std::size_t>(view.elsewhere.size()));
    if (who.isEmpty() && unnamed == 0)
        return view.seen ? QString::fromUtf8(words_.no_faces) : QString();
    const bool alone = view.people.size() == 1 && view.elsewhere.isEmpty();
    if (unnamed > 0)
        who << (who.isEmpty() ? count(unnamed) : more(unnamed));
    return one_after_another(
        {list(who), alone ? word(words_.mien, view.people.front().face.mien) : smiles_on(view)});
}

QString CaptionGrammar::people(const PhotoView& view) const { return told(view, Moment::past); }

QString CaptionGrammar::taken(const PhotoView& view) const {
    return QString::fromUtf8(words_.taken) + told(view, Moment::now);
}

QString CaptionGrammar::told(const PhotoView& view, Moment moment) const {
    const QString also = list(view.elsewhere);
    if (view.people.empty())
        return also.isEmpty() && view.seen ? QString::fromUtf8(words_.no_faces) : also;
    const bool alone = view.people.size() == 1, crowd = view.people.size() > most_told;
    QStringList told;
    for (const PersonShown& one : view.people)
        if (!crowd || !one.name.isEmpty())
            told << person(one, alone, moment);
    if (!also.isEmpty())
        told << QString::fromUtf8(words_.named) + also;
    const bool all_named = std::none_of(view.people.begin(), view.people.end(),
                                        [](const PersonShown& one) { return one.name.isEmpty(); });
    if (alone || (moment == Moment::now && all_named && !crowd))
        return told.join(QStringLiteral("; "));
    const QString all = one_after_another({count(view.people.size()), crowd ? smiles_on(view) : QString()});
    return told.isEmpty() ? all : all + ": " + told.join(QStringLiteral("; "));
}

QString CaptionGrammar::person(const PersonShown& person, bool alone, Moment moment) const {
    const QString who = !person.name.isEmpty() ? person.name
                        : alone                ? count(1)
                                               : QString::fromUtf8(words_.one_of_several);
    const bool now = moment == Moment::now;
    const bool place_says_nothing = alone && person.spot.kind == Spot::Kind::middle && !now;
    const QString spot = word(words_.spot, person.spot.kind).replace("%1", ordinal(person.spot.number));
    const bool facing_says_nothing = (!alone || now) && person.face.facing == Facing::camera;
    const QString eyes = now && person.face.eyes == Eyes::open ? QString::fromUtf8(words_.eyes_open)
                                                               : word(words_.eyes, person.face.eyes);
    return one_after_another({place_says_nothing ? who : placed(who, spot),
                              person.further_back ? QString::fromUtf8(words_.further_back) : QString(),
                              person.face.cut_off ? QString::fromUtf8(words_.cut_off) : QString(),
                              word(words_.mien, person.face.mien), eyes,
                              facing_says_nothing ? QString() : word(words_.facing, person.face.facing)});
}

QString CaptionGrammar::smiles_on(const PhotoView& view) const {
    const std::size_t smile = smiling(view);
    return smile == 0 ? QString() : smiles(smile, view.people.size());
}

QString CaptionGrammar::faults(const PhotoView& view) const {
    return one_after_another({view.blurred ? QString::fromUtf8(words_.blurred) : QString(),
                              view.light == Light::dark ? QString::fromUtf8(words_.a_little_dark)
                                                        : word(words_.light, view.light)});
}

QString CaptionGrammar::picture(const PhotoView& view) const {
    return one_after_another({word(words_.shape, shape_of(view)),
                              view.people.empty() ? QString() : word(words_.nearness, view.nearness),
                              word(words_.colours, view.colours),
                              view.blurred ? QString::fromUtf8(words_.blurred) : QString(),
                              word(words_.light, view.light)});
}

} // namespace tp
