<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
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
        <source>%n of them there already</source>
        <translation>
            <numerusform>%n of them there already</numerusform>
            <numerusform>%n of them there already</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n failed</source>
        <translation>
            <numerusform>%n failed</numerusform>
            <numerusform>%n failed</numerusform>
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
        <source>Looking at faces, %n photograph(s) left…</source>
        <translation>
            <numerusform>Looking at faces, %n photograph left…</numerusform>
            <numerusform>Looking at faces, %n photographs left…</numerusform>
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
        <source>The name %1 is cut after %n line(s) of braille.</source>
        <translation>
            <numerusform>The name %1 is cut after %n line of braille.</numerusform>
            <numerusform>The name %1 is cut after %n lines of braille.</numerusform>
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
        <source>%n photograph(s) without a face passed over.</source>
        <translation>
            <numerusform>%n photograph without a face passed over.</numerusform>
            <numerusform>%n photographs without a face passed over.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Looking further: %n photograph(s) without a face so far.</source>
        <translation>
            <numerusform>Looking further: %n photograph without a face so far.</numerusform>
            <numerusform>Looking further: %n photographs without a face so far.</numerusform>
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
        <source>%n folder(s) below it</source>
        <translation>
            <numerusform>%n folder below it</numerusform>
            <numerusform>%n folders below it</numerusform>
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
        <source>%1, %n point(s), none in hand.</source>
        <translation>
            <numerusform>%1, %n point, none in hand.</numerusform>
            <numerusform>%1, %n points, none in hand.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::OpenAlbum</name>
    <message numerus="yes">
        <source>%n more thing(s) in the album need a look.</source>
        <translation>
            <numerusform>%n more thing in the album needs a look.</numerusform>
            <numerusform>%n more things in the album need a look.</numerusform>
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
</TS>
