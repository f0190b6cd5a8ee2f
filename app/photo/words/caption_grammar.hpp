// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/photo/words/description.hpp"

#include <array>
#include <cstddef>

namespace tp {

/// A language's words, in the order of their kinds; UTF-8, empty where nothing is said.
struct CaptionWords {
    std::array<const char*, 5> mien;
    std::array<const char*, 4> eyes, facing;
    std::array<const char*, 5> shape;
    std::array<const char*, 4> nearness;
    std::array<const char*, 7> colours;
    std::array<const char*, 4> light;
    std::array<const char*, 8> spot; ///< "%1": which one from the left
    const char* no_faces;
    const char* one_of_several;
    const char* further_back;
    const char* cut_off;
    const char* blurred;
    const char* named; ///< before names of whom nobody said which face is theirs
    const char* taken; ///< before who is on a photograph that was taken just now
    const char* eyes_open;
    const char* a_little_dark; ///< of all of it
};

/// What languages share in which a description can be a caption: who there is, a colon, one after the other; then the
/// picture's properties one after the other. Each word, its form and its place is the language's own.
class CaptionGrammar : public DescriptionGrammar {
public:
    explicit CaptionGrammar(const CaptionWords& words) : words_(words) {}

    QString people_in_short(const PhotoView& view) const final;
    QString people(const PhotoView& view) const final;
    QString picture(const PhotoView& view) const final;
    QString taken(const PhotoView& view) const final;
    QString faults(const PhotoView& view) const final;

protected:
    virtual QString count(std::size_t people) const = 0;   ///< "three people"
    virtual QString more(std::size_t people) const = 0;    ///< "three more people"
    virtual QString ordinal(std::size_t number) const = 0; ///< "second"
    /// "Anna at the left"
    virtual QString placed(const QString& who, const QString& spot) const = 0;
    /// Of at least one who smiles: "two of them smiling", "all smiling".
    virtual QString smiles(std::size_t smiling, std::size_t people) const = 0;
    virtual QString list(const QStringList& names) const = 0; ///< "Anna, Tom, and Eva"

private:
    /// Of one who was just photographed it is also said that they are in the middle, and that their eyes are open. Where all of
    /// several are known, how many they are is not: their names come first.
    enum class Moment { past, now };
    QString told(const PhotoView& view, Moment moment) const;
    QString person(const PersonShown& person, bool alone, Moment moment) const;
    QString smiles_on(const PhotoView& view) const;

    const CaptionWords& words_;
};

} // namespace tp
