// SPDX-License-Identifier: Apache-2.0
#include "flac_check.hpp"

#include "audio/recordings/flac_head.hpp"
#include "audio/recordings/recording_notes.hpp"
#include "failing_bytes.hpp"

namespace tp::test {

namespace {

bool in_words(const std::string& error) { return error.size() > 10 && error.ends_with('.'); }

std::string complaint_about_comments(const VorbisComments& comments) {
    const auto block = vorbis_comment_block(comments);
    if (!block)
        return in_words(block.error()) ? "" : "refused without words";
    const auto again = vorbis_comments(*block);
    if (!again || *again != comments)
        return "comments changed by writing";
    const RecordingNotes notes = notes_in(comments);
    VorbisComments written = comments;
    set_notes(written, notes);
    const RecordingNotes read = notes_in(written);
    if (read.label != notes.label || read.chapters.size() != notes.chapters.size())
        return "notes changed by writing";
    set_notes(written, read);
    return notes_in(written) == read ? "" : "notes changed by writing again";
}

std::string complaint_about_head(std::string_view bytes) {
    on_failing_disks(bytes, [](const ByteSource& file) {
        if (const auto head = flac_head(file))
            static_cast<void>(write_with_comments(file, *head, head->comments,
                                                  [](std::string_view) { return std::string(); }));
    });
    const MemoryBytes file(bytes);
    const auto head = flac_head(file);
    if (!head)
        return in_words(head.error()) ? "" : "refused without words";
    if (!is_flac(file))
        return "it has a head and is no FLAC";
    for (const FlacHead::Block& block : head->blocks)
        if (block.body + block.size > head->sound_begin)
            return "a block reaches into the sound";
    if (head->sound_begin > bytes.size())
        return "the sound begins after the end";
    if (std::string complaint = complaint_about_comments(head->comments); !complaint.empty())
        return complaint;
    VorbisComments comments = head->comments;
    RecordingNotes notes;
    notes.label.person = "Anna";
    notes.chapters = {{61.5, "See"}};
    set_notes(comments, notes);
    std::string written;
    const std::string reason = write_with_comments(file, *head, comments, [&](std::string_view more) {
        written += more;
        return std::string();
    });
    if (!reason.empty())
        return in_words(reason) ? "" : "refused without words";
    const auto again = flac_head(MemoryBytes(written));
    if (!again || again->comments != comments)
        return "other comments than were written";
    return written.substr(again->sound_begin) == bytes.substr(head->sound_begin) ? "" : "another sound";
}

} // namespace

std::string complaint_about_flac(std::string_view bytes) {
    if (const auto comments = vorbis_comments(bytes))
        if (std::string complaint = complaint_about_comments(*comments); !complaint.empty())
            return complaint;
    return complaint_about_head(bytes);
}

} // namespace tp::test
