<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>AimWords</name>
    <message numerus="yes">
        <source>%n face(s).</source>
        <translation>
            <numerusform>%n face.</numerusform>
            <numerusform>%n faces.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more face(s)</source>
        <comment>at the end of a list of names</comment>
        <translation>
            <numerusform>%n more face</numerusform>
            <numerusform>%n more faces</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>CareWords</name>
    <message numerus="yes">
        <source>%n recording(s).</source>
        <translation>
            <numerusform>%n recording.</numerusform>
            <numerusform>%n recordings.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s) imported</source>
        <translation>
            <numerusform>%n photograph imported</numerusform>
            <numerusform>%n photographs imported</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of them already in the album</source>
        <translation>
            <numerusform>%n of them already in the album</numerusform>
            <numerusform>%n of them already in the album</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n failed</source>
        <translation>
            <numerusform>%n failed</numerusform>
            <numerusform>%n failed</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s)</source>
        <translation>
            <numerusform>%n photograph</numerusform>
            <numerusform>%n photographs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n to confirm</source>
        <translation>
            <numerusform>%n to confirm</numerusform>
            <numerusform>%n to confirm</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n person(s) without a name.</source>
        <translation>
            <numerusform>%n person without a name.</numerusform>
            <numerusform>%n people without a name.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s) still to be looked at.</source>
        <translation>
            <numerusform>%n photograph still to be looked at.</numerusform>
            <numerusform>%n photographs still to be looked at.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n face(s) on one photograph only.</source>
        <translation>
            <numerusform>%n face on one photograph only.</numerusform>
            <numerusform>%n faces on one photograph only.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n face(s) too small, blurred, turned or covered to be compared.</source>
        <translation>
            <numerusform>%n face too small, blurred, turned or covered to be compared.</numerusform>
            <numerusform>%n faces too small, blurred, turned or covered to be compared.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n face(s) to confirm.</source>
        <translation>
            <numerusform>%n face to confirm.</numerusform>
            <numerusform>%n faces to confirm.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of these with something new</source>
        <translation>
            <numerusform>%n of these with something new</numerusform>
            <numerusform>%n of these with something new</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>LabWords</name>
    <message numerus="yes">
        <source>%n tick(s)</source>
        <translation>
            <numerusform>%n tick</numerusform>
            <numerusform>%n ticks</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>PhotoListPane</name>
    <message numerus="yes">
        <source>Checking faces, %n photograph(s) left…</source>
        <translation>
            <numerusform>Checking faces, %n photograph left…</numerusform>
            <numerusform>Checking faces, %n photographs left…</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>PhotoWords</name>
    <message numerus="yes">
        <source>%n face(s)</source>
        <translation>
            <numerusform>%n face</numerusform>
            <numerusform>%n faces</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more face(s)</source>
        <translation>
            <numerusform>%n more face</numerusform>
            <numerusform>%n more faces</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1; %n recording(s).</source>
        <translation>
            <numerusform>%1; %n recording.</numerusform>
            <numerusform>%1; %n recordings.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n face(s) without a name.</source>
        <translation>
            <numerusform>%n face without a name.</numerusform>
            <numerusform>%n faces without a name.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s)</source>
        <translation>
            <numerusform>%n hour</numerusform>
            <numerusform>%n hours</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n minute(s)</source>
        <translation>
            <numerusform>%n minute</numerusform>
            <numerusform>%n minutes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n second(s)</source>
        <translation>
            <numerusform>%n second</numerusform>
            <numerusform>%n seconds</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s).</source>
        <translation>
            <numerusform>%n recording.</numerusform>
            <numerusform>%n recordings.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>TactileNotes</name>
    <message numerus="yes">
        <source>%n character(s) of the name %1 have no braille and are left out.</source>
        <translation>
            <numerusform>%n character of the name %1 have no braille and are left out.</numerusform>
            <numerusform>%n characters of the name %1 have no braille and are left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The name %1 is cut off after %n line(s) of braille.</source>
        <translation>
            <numerusform>The name %1 is cut off after %n line of braille.</numerusform>
            <numerusform>The name %1 is cut off after %n lines of braille.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::BrowseLists</name>
    <message numerus="yes">
        <source>%n photograph(s)</source>
        <translation>
            <numerusform>%n photograph</numerusform>
            <numerusform>%n photographs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n year(s)</source>
        <translation>
            <numerusform>%n year</numerusform>
            <numerusform>%n years</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n person(s)</source>
        <translation>
            <numerusform>%n person</numerusform>
            <numerusform>%n persons</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n place(s)</source>
        <translation>
            <numerusform>%n place</numerusform>
            <numerusform>%n places</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n keyword(s)</source>
        <translation>
            <numerusform>%n keyword</numerusform>
            <numerusform>%n keywords</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s) or more</source>
        <translation>
            <numerusform>%n photograph or more</numerusform>
            <numerusform>%n photographs or more</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n suggestion(s)</source>
        <translation>
            <numerusform>%n suggestion</numerusform>
            <numerusform>%n suggestions</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::CareSession</name>
    <message numerus="yes">
        <source>%n photograph(s).</source>
        <translation>
            <numerusform>%n photograph.</numerusform>
            <numerusform>%n photographs.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::ExploreEar</name>
    <message numerus="yes">
        <source>%1 o&apos;clock, %n millimetre(s)</source>
        <translation>
            <numerusform>%1 o&apos;clock, %n millimetre</numerusform>
            <numerusform>%1 o&apos;clock, %n millimetres</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::ExploreHand</name>
    <message numerus="yes">
        <source>%1: %2 o&apos;clock, %n millimetre(s).</source>
        <translation>
            <numerusform>%1: %2 o&apos;clock, %n millimetre.</numerusform>
            <numerusform>%1: %2 o&apos;clock, %n millimetres.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::ExploreTour</name>
    <message numerus="yes">
        <source>Tour of %1: %n feature(s). %2.</source>
        <translation>
            <numerusform>Tour of %1: %n feature. %2.</numerusform>
            <numerusform>Tour of %1: %n features. %2.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::ExploreWalk</name>
    <message numerus="yes">
        <source>Skipped %n photograph(s) without a face.</source>
        <translation>
            <numerusform>Skipped %n photograph without a face.</numerusform>
            <numerusform>Skipped %n photographs without a face.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Still looking: %n photograph(s) without a face so far.</source>
        <translation>
            <numerusform>Still looking: %n photograph without a face so far.</numerusform>
            <numerusform>Still looking: %n photographs without a face so far.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::ExploreZoom</name>
    <message numerus="yes">
        <source>Zoomed out to all %n face(s).</source>
        <translation>
            <numerusform>Zoomed out to all %n face.</numerusform>
            <numerusform>Zoomed out to all %n faces.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::ExtractionWords</name>
    <message numerus="yes">
        <source>%n face(s).</source>
        <translation>
            <numerusform>%n face.</numerusform>
            <numerusform>%n faces.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::FaceCare</name>
    <message numerus="yes">
        <source>%n face(s)</source>
        <translation>
            <numerusform>%n face</numerusform>
            <numerusform>%n faces</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n without a name</source>
        <translation>
            <numerusform>%n without a name</numerusform>
            <numerusform>%n without a name</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::FolderChooser</name>
    <message numerus="yes">
        <source>%n photograph(s) in this folder itself</source>
        <translation>
            <numerusform>%n photograph in this folder itself</numerusform>
            <numerusform>%n photographs in this folder itself</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n subfolder(s)</source>
        <translation>
            <numerusform>%n subfolder</numerusform>
            <numerusform>%n subfolders</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::GroupCare</name>
    <message numerus="yes">
        <source>%n photograph(s)</source>
        <translation>
            <numerusform>%n photograph</numerusform>
            <numerusform>%n photographs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::LabArchive</name>
    <message numerus="yes">
        <source>%n row(s) are in %1; the parameters lie beside them.</source>
        <translation>
            <numerusform>%n row are in %1; the parameters lie beside them.</numerusform>
            <numerusform>%n rows are in %1; the parameters lie beside them.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::LabScene</name>
    <message numerus="yes">
        <source>%1: %n line(s) can be felt.</source>
        <translation>
            <numerusform>%1: %n line can be felt.</numerusform>
            <numerusform>%1: %n lines can be felt.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::MendSelection</name>
    <message numerus="yes">
        <source>%1, %n point(s).</source>
        <translation>
            <numerusform>%1, %n point.</numerusform>
            <numerusform>%1, %n points.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1, %n point(s), none selected.</source>
        <translation>
            <numerusform>%1, %n point, none selected.</numerusform>
            <numerusform>%1, %n points, none selected.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::OpenAlbum</name>
    <message numerus="yes">
        <source>%n more thing(s) in the album need checking.</source>
        <translation>
            <numerusform>%n more thing in the album needs checking.</numerusform>
            <numerusform>%n more things in the album need checking.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::PlaceWords</name>
    <message numerus="yes">
        <source>%1. On the %2, at its %3 o&apos;clock, %n millimetre(s) from its middle.</source>
        <translation>
            <numerusform>%1. On the %2, at its %3 o&apos;clock, %n millimetre from its middle.</numerusform>
            <numerusform>%1. On the %2, at its %3 o&apos;clock, %n millimetres from its middle.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Beside %1. %2 at %3 o&apos;clock, %n millimetre(s).</source>
        <translation>
            <numerusform>Beside %1. %2 at %3 o&apos;clock, %n millimetre.</numerusform>
            <numerusform>Beside %1. %2 at %3 o&apos;clock, %n millimetres.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1. %2 at %3 o&apos;clock, %n millimetre(s).</source>
        <translation>
            <numerusform>%1. %2 at %3 o&apos;clock, %n millimetre.</numerusform>
            <numerusform>%1. %2 at %3 o&apos;clock, %n millimetres.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::StartSession</name>
    <message numerus="yes">
        <source>%n new photograph(s)</source>
        <translation>
            <numerusform>%n new photograph</numerusform>
            <numerusform>%n new photographs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n with people</source>
        <translation>
            <numerusform>%n with people</numerusform>
            <numerusform>%n with people</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::TickSettings</name>
    <message numerus="yes">
        <source>Ticks are felt %n millisecond(s) late.</source>
        <translation>
            <numerusform>Ticks are felt %n millisecond late.</numerusform>
            <numerusform>Ticks are felt %n milliseconds late.</numerusform>
        </translation>
    </message>
</context>
</TS>
