<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>BrowseButtons</name>
    <message>
        <source>Choose folders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the settings page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import photographs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the detail of a recording: that one alone. Key: Return</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Photograph. Key: left arrow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Photograph. Key: right arrow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Detail before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: up arrow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next detail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>People, recordings, descriptions, place and time. Key: down arrow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feel the face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: E</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the list before. Key: Backspace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All photographs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: S</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surprise me</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Any photograph. Key: R</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>People</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: P</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Years</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: L</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keywords</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: K</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slower</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Key: minus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faster</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Key: plus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where am I?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: W</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tells every key of this page. Key: H</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look after this photograph</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its names, recordings and descriptions. Key: C</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>BrowseKeys</name>
    <message>
        <source>Left, Right: photograph · Up, Down: details · Enter: recordings · Escape: stop · +, −: speed
Home, End: first, last · S: search · P: people · Y: years · L: places · K: keywords · R: surprise
A: all · Backspace: back · E: feel the face · C: look after it · W: where am I · H: keys</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CarePage</name>
    <message>
        <source>Tab goes from control to control, the arrow keys from photograph to photograph, Return opens one. Control Z takes the last step back, Control Shift Z does it again. Escape stops what plays, and ends a recording and keeps it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import a folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder for the album</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CareWords</name>
    <message>
        <source>Memo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Story</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sounds around</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, about %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>spoken by %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s).</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>No description.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 photographs, %3 of %4 megabytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, about %2 left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The import was stopped before the first photograph.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no photograph among what was chosen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s) imported</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of them there already</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n failed</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 The import was stopped; it can go on later.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>DescriptionPart</name>
    <message>
        <source>Description</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In one sentence (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 characters; a screen reader reads up to 250 in one piece.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of 250 characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In more words (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the description</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The description is saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is saved too when a field is left.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>DialogLoader</name>
    <message>
        <source>The file dialog is not installed. Drop files or folders on this window instead.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ExplorePage</name>
    <message>
        <source>The file dialog is not installed. Drop a photograph on this window instead.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FaceTargets</name>
    <message>
        <source>Fits this face into the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sets the finger down there</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FacesPart</name>
    <message>
        <source>Faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press to name it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who is face %1?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody I know</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leaves the face as it is.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FingerMarks</name>
    <message>
        <source>%1 N</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FolderChooserView</name>
    <message>
        <source>Take this folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the folder above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not choose a folder</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ImportPart</name>
    <message>
        <source>Stop the import</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import photographs…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Or drop them on this window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import a folder…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Into</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on with the unfinished import</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the unfinished import up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it brought stays.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>KeyHelp</name>
    <message>
        <source>Arrow keys, with Shift faster: move the hand. Tab: next feature. W: where am I. Z, Shift+Z: zoom in and out. Space: tour of the feature. T: tour of the face. G: guide. F: next face. Enter: force on. Escape: stop. V: voice. O: open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch: one finger explores. Double tap: where am I. Double tap and hold: zoom to what is there, or out. Two-finger tap: stop. Two-finger double tap: tour. Three-finger tap: where am I.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the picture: ring, the hand; disc, the finger; arrow, the pull of the line.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LabControls</name>
    <message>
        <source>What is felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a photograph</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: O. One can be dropped on the page too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Law</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness K</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range d</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hysteresis at switches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blending at switches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corner cue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spacing of vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Servo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strongest force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Damping across a line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Energy observer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits of a real device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look for devices again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Damping of the device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dry friction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Encoder step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grip of the hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Damping of the hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faults of the simulated device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Readings that do not come</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No readings at all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes no force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motors off by themselves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unplugged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hang for 200 milliseconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing to take back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take back: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: Control Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As they were at first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It can be taken back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the plots as a table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV, with the parameters as JSON beside it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No recordings yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LabOpenDialog</name>
    <message>
        <source>Open photograph</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Photographs (*.jpg *.jpeg *.png *.webp *.tif *.tiff *.bmp *.jp2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LabPage</name>
    <message>
        <source>On the surface arrow keys move the hand and Space starts and stops the servo. R records, W says where the finger is, P reads the plots, O opens a photograph, Control Z takes a change back. Escape stops what runs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start the servo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: Space on the surface; Escape stops</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: R</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where is the finger?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: W</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read the plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: P</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LabSurface</name>
    <message>
        <source>Arrow keys move the hand by 2 millimetres, with Shift by 10. Space starts and stops the servo.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LabelPart</name>
    <message>
        <source>Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About whom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About nobody in particular</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who speaks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speaker not said</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MendPanel</name>
    <message>
        <source>Mend contours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leaving this page saves too. Key: Control+S</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: Control+Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: not there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of the %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: Shift+Tab on the photograph</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: Tab on the photograph</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By one pixel of the photograph. Arrow keys: with Shift by ten, with Control by a fifth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the whole feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Behind the one in hand. Key: A. Or double-click beside a line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make it smooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make it a corner</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As it was found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes back what was done to this feature alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It will not be felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add the %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Larger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: Plus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: Minus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole photograph</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fits it into view. Key: Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: Control+Shift+Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One of usual shape, to be put in place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discard all changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The contours as they were opened. Can be undone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys on the photograph: Tab and Shift+Tab go from point to point; arrows move it by one pixel, with Shift by ten, with Control by a fifth; Page up and Page down change the feature; A adds a point, Delete deletes it, C turns a corner, M moves the whole feature, F shows the force, plus and minus zoom, 0 shows all, Z this feature, W says where one is.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MendSurface</name>
    <message>
        <source>Contours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tab goes from point to point. Arrow keys move it by one pixel of the photograph, with Shift by ten, with Control by a fifth. Page up and page down change the feature.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 across, %2 down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No photograph yet.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MendWords</name>
    <message>
        <source>Corner %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bend %1 of %2</source>
        <comment>a control point beside the line</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 across, %2 down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It feels as the program found it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A finger will not notice the difference to what the program found.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A finger notices the difference to what the program found on %1 % of the surface; there the force differs by up to %2 N.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>NameField</name>
    <message>
        <source>Type, or choose below</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>NameList</name>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: Backspace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A name, a place or any word</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the row before. Key: up arrow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the next row. Key: down arrow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The row that was told last. Key: Return</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>OpenDialog</name>
    <message>
        <source>Open photograph</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Photographs (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All files (%1)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PhotoListPane</name>
    <message>
        <source>Photographs of the album</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Newest first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looks wrong first</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Looking at faces, %n photograph(s) left…</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>No photograph is in the album yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The album has no folder yet. You are asked for one when you import.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PhotoPane</name>
    <message>
        <source>%1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left and right arrow: other photographs. Up and down: what is known. Return: recordings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the photographs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The photograph</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mend the contours…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Print a tactile sheet…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the photograph</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With everything that is its own. Undo brings it back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a photograph to care for it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PhotoWords</name>
    <message numerus="yes">
        <source>%n face(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more face(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <comment>between who, when and where</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; no recordings yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1; %n recording(s).</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n face(s) without a name.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Recording %1 of %2: %3, %4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place: %1 degrees north, %2 degrees east.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taken: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keywords: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, </source>
        <comment>between keywords</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>memo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>memo by %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about a person</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about a person, by %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about %1, by %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about the place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about the place, by %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>story</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>story by %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sounds around the camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n minute(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n second(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>the month&apos;s name and the year</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>a day and a time</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PhotosDialog</name>
    <message>
        <source>Import photographs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Photographs and bundles (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All files (%1)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PrintPage</name>
    <message>
        <source>Choose the paper and the face, then store the sheet as PDF for a printer or as SVG for a drawing program. Swell paper and embossers raise its black lines and dots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sheet, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No sheet yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No photograph</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turned by a quarter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its name in print</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Store as PDF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Store as SVG</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RecordingsPart</name>
    <message>
        <source>Recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No recording yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chosen: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop playing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play earlier</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves it up in the list.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves it down in the list.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record it anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The old one goes to the trash when the new one is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the label</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Label…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kind, person, speaker and language.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo brings it back.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SettingsPage</name>
    <message>
        <source>Tab goes from setting to setting, Space or Return changes one, arrow keys move a slider. Control Z takes the last change back. Each change is kept at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speech and sound</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who speaks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of speech</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sounds for what happens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it looks like</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size of text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 percent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures may move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who uses the tablet most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strongest force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 newtons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try the force on a face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What guides the finger where no force does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Irises</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folders of the album</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No folder yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take %1 off the album</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The photographs stay where they are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is stored about me</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Throw the index away and make it anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing to take back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take back: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: Control Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ask me the five questions again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything as it was at first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The album&apos;s folders stay; it can be taken back</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ShellView</name>
    <message>
        <source>Home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: Escape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Says what can be done here. Key: F1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Said last</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SidePanel</name>
    <message>
        <source>Explore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Under the finger: nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Under the finger: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guided tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leads the finger once round the feature. Key: Space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tour of the face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leads the finger round every feature, each named before. Key: T</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where am I?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tells face, feature, direction and distance. Key: W</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends tour, speech and force. Key: Escape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: Enter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the face, its eyes, its mouth, and back. Key: Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: Shift and Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next feature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sets the finger down on it. Key: Tab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fits one face after the other into the surface. Key: F</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strongest force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 newtons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Voice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open photograph…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: O</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SoundsDialog</name>
    <message>
        <source>Add sound files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sounds (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All files (%1)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StartPage</name>
    <message>
        <source>Press the number of an answer, or the answer itself. 0 or Backspace: the question before. R: hear the question again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press the number of what you want to do, or go through the buttons by Tab. R: hear this page again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Question %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hear it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: R</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Question before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: 0</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SurfaceView</name>
    <message>
        <source>Touch surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move a finger to hear what is under it. Arrow keys move the hand, Tab goes from feature to feature, Space starts the guided tour, Z zooms in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No photograph yet. Press O, or drop one here.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TactileNotes</name>
    <message numerus="yes">
        <source>%n character(s) of the name %1 have no braille and are left out.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The name %1 is cut after %n line(s) of braille.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>The %1 is drawn as one line, because its two sides would be too close to be told apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The %1 is drawn in part, because the rest would be less than 3 mm from another line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The %1 is left out, because it would be too small or less than 3 mm from another line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The name %1 is left out, because there is no room for its braille.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TakePart</name>
    <message>
        <source>What to record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finish the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Throw away…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yes, throw it away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a sound file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loudness</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TpButton</name>
    <message>
        <source>%1, not available</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TpChoice</name>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TpListRow</name>
    <message>
        <source>%1, %2 of %3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TrimPart</name>
    <message>
        <source>Begin of what stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End of what stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Listen to what stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trim to what stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The rest can be brought back with Undo.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep all of it</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>UndoBar</name>
    <message>
        <source>Undo: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: Control Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do again: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key: Control Shift Z</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>WordsPane</name>
    <message>
        <source>Photograph</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Detail</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::BrowseSession</name>
    <message>
        <source>People</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Years</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keywords</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no photograph of that any more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <comment>list, place in it, summary</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These are all photographs; there is no list above them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n year(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n person(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n place(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n keyword(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>The first %1</source>
        <comment>of a long list</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>person, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>place, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>keyword, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s) or more</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>two counts</comment>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n suggestion(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1.</source>
        <comment>what was found</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search. Type a name, a place or a word; the arrow keys go through what is found.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search for %1: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: there are none yet.</source>
        <comment>a list</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2. Choose one with the arrow keys and Return.</source>
        <comment>a list, how many</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>a row and what belongs to it</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Found: %1</source>
        <comment>a search</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All photographs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is gone from this list. Now: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no album yet. Choose the folders of your photographs on the settings page, or import photographs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for photographs in your folders.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no photograph in your folders yet. Import some, or choose other folders on the settings page.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for what is new in your folders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading new photographs, %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, about %2 left</source>
        <comment>progress, and a time</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>a place in a list</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swipe or use the arrow keys to go on; double tap or press Return to hear.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swipe or use the arrow keys to go on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your photographs, %1: %2 %3</source>
        <comment>place, summary, what can be done</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is the last photograph.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is the first photograph.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 Paused: %2, at %3.</source>
        <comment>where one is; the recording and the time in it</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This photograph has no recordings yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 of %3</source>
        <comment>a recording, and times in it</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed %1</source>
        <comment>of recordings</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left and right: previous and next photograph. Up and down: what is known of it. Return: hear the recordings, or pause. Escape: stop. Plus and minus: faster and slower. Home and End: first and last photograph. S: search. P: people. Y: years. L: places. K: keywords. R: surprise me. A: all photographs. Backspace: back. E: feel the face. C: look after this photograph. W: where am I. H: these keys.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to a row first.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::CareSession</name>
    <message>
        <source>Care for the album. It has no folder yet. Import photographs, and choose where they are kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Care for the album. %1 is open: its faces, recordings and description.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Care for the album. %1 Choose one, or import more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s).</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Deleted: %1. Undo brings it back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undone: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done again: %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::DescriptionCare</name>
    <message>
        <source>The description is saved.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::ExploreSession</name>
    <message>
        <source>Tour ended.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1 o&apos;clock, %n millimetre(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>the face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>face %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no photograph yet. Press O, or the button Open photograph, to choose one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for faces…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Explore. %1 Move a finger over the picture; W tells where it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Explore. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only a photograph that is a file on this computer can be opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoomed out to the whole face.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Zoomed out to all %n face(s).</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Zoomed to the eyes of %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoomed to the eyes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoomed to the left eye of %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoomed to the left eye.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoomed to the right eye of %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoomed to the right eye.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoomed to the mouth of %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoomed to the mouth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoomed to %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This part is too small in the picture to zoom to it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is the whole picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing nearer to zoom to here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The force is off. Press Enter to switch it on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tour round the %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Tour of %1: %n feature(s). %2.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Tour finished.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped looking. Press O to open a photograph.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped looking. %1 is open again. The force is off. Press Enter to switch it on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped looking. %1 is open again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped. The force is off. Press Enter to switch it on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The force is on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to feel here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sonar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clock voice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guide: %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::ExploreWindow</name>
    <message>
        <source>%1 – TouchPhoto</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::ExtractionWords</name>
    <message>
        <source>One face.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two faces.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Three faces.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Four faces.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n face(s).</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <comment>the end of a list</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>eyes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mouth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>brows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>irises</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1.</source>
        <comment>who is on the picture</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 can be felt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of each can be felt.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::FaceCare</name>
    <message>
        <source>Face without a name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for faces…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No face was found on this photograph.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n face(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1, all with a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n without a name</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2 of %3. Type a name or choose one below.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This face has no name now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 Who is the next face?</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::FeatureLabels</name>
    <message>
        <source>left eye</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right eye</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mouth opening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>face outline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left brow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right brow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left iris</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right iris</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>left eye of Anna</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of face %2</source>
        <comment>left eye of face 2</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::FolderChooser</name>
    <message>
        <source>no photographs in this folder itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s) in this folder itself</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>The folder %1 cannot be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the whole computer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no folders below it</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n folder(s) below it</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Folder %1: %2, %3.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::ImportCare</name>
    <message>
        <source>Looking for photographs…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An import is under way. Wait for its end, or stop it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only photographs and folders on this computer can be imported.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the folder in which the album is to lie. The photographs are copied into it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Importing…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The album needs a folder on this computer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The album has the folder %1 now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopping after this photograph.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The import goes on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The import is not gone on with. What it brought stays.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::KeeperSteps</name>
    <message>
        <source>There is nothing to undo.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to do again.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::LabSession</name>
    <message>
        <source>Nothing runs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lab. A finger on a simulated device, a force field, and everything that can be turned. Space on the surface starts the servo, Escape stops it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Photograph</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Photograph %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circle, radius 40 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Triangle, 50 mm high</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curved path, 200 mm wide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only a photograph that is a file on this computer can be opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no photograph yet. Open one, or drop one on the page.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for faces in %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1: %n line(s) can be felt.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Force field of %1: colours and arrows from 0 to %2 newtons. The rule is 20 mm long.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Published Algorithm 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing can be changed during a recording. Escape ends it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing can be changed during a replay. Escape ends it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the law</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 newtons per millimetre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 newtons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 newton seconds per metre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 grams</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n tick(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1 percent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of critical damping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 millimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Law, servo, device and faults are as they were at first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to take back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taken back: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated: the mouse or a finger on the screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording on %1. Escape ends it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The servo runs on %1. Escape stops it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only a simulated device that runs can be made to hang.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device hangs for 200 milliseconds.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 of the middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The finger is %1. </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No line pulls there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm from %2; the law pulls with %3 newtons.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The replay has ended. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position: nothing measured yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force |F|: nothing measured yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Energy: nothing measured yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lateness: nothing measured yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position now x %1, y %2 mm; x from %3 to %4, y from %5 to %6.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force |F| now %1 newtons, at most %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Energy given to the hand now %1 millijoules, from %2 to %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ticks late by now %1 milliseconds, at most %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder %1 cannot be made: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording cannot be begun: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording is not whole, because the disk is full or this computer was too busy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded in %1; the parameters lie beside it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computed again, the forces differ by at most %1 newtons.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its parameters are not beside it, so it was not computed again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its end was cut short and is left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 holds nothing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaying %1. Escape ends it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to write yet. Start the servo first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) are in %1; the parameters lie beside them.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::MendSession</name>
    <message>
        <source>Only a photograph that is a file on this computer can be opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for faces…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Here the contours of a photograph are mended. There is no photograph yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a photograph and what is wrong with it</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No face was found in %1. One of usual shape can be added and put in place.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contours of %1. In hand: %2. Tab goes from point to point, the arrow keys move it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1, %n point(s).</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1: not there. It can be added.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1, %n point(s), none in hand.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of the %2: %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The whole feature moves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One point moves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the %1 was moved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a point of the %1 was moved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 moved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No point is in hand. Tab goes from point to point.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a point of the %1 was added</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Added. %1: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The %1 needs its last points. The whole feature can be removed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a point of the %1 was deleted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deleted. In hand: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This point can be no corner.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a point of the %1 was turned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A corner now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smooth now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The %1 is as the program found it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the %1 was reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The %1 is as the program found it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The %1 is gone again: the program did not find it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The %1 is there already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the %1 was added</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The %1 is there, as the program found it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The %1 was added in its usual shape. Move it into place.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the %1 was removed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The %1 is removed. It will not be felt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a face was added</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A face of usual shape was added. Move its features into place.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undone: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to do again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done again: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 Your work is kept here; nothing is lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The contours are saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The contours are saved. Another program had changed them; what it wrote is kept as %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all changes were discarded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All changes are discarded: the contours are as they were opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The force is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The force is hidden.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::Narrator</name>
    <message>
        <source>Voice on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Voice off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No speech engine was found on this computer, so nothing is spoken here. A screen reader is told instead.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::OpenAlbum</name>
    <message numerus="yes">
        <source>%n more thing(s) in the album need a look.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::PhotoRows</name>
    <message>
        <source>Not looked at yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No face found.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faces look wrong: %1 % off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faces about %1 % off.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::PlaceWords</name>
    <message numerus="yes">
        <source>%1. On the %2, at its %3 o&apos;clock, %n millimetre(s) from its middle.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Beside %1. %2 at %3 o&apos;clock, %n millimetre(s).</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1. %2 at %3 o&apos;clock, %n millimetre(s).</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::Preferences</name>
    <message>
        <source>Your settings could not be read. The usual ones are used until that is mended.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your settings could not be read and were set aside. The usual ones are used; you can choose anew on the settings page.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your settings could not be kept: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::PrintSession</name>
    <message>
        <source>Print. Choose a photograph on the page for looking after the album.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Print %1. Looking for faces…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Print %1 on %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Letter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Braille paper, 11 by 11.5 inches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 by %2 millimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With its name in print.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without a name in print.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no sheet yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder %1 could not be made: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sheet is stored as %1. Print it at 100 percent, unscaled.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::Problems</name>
    <message>
        <source>The force was switched off for a moment, because a measurement was not a number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The force is off, because the finger is outside the area that the device reaches. Move it back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The force is off, because the finger moves too fast. Move slowly and it comes back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The force is off, because the device has switched its motors off to be safe. It comes back when the device is ready.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The force is off, because the device does not say where the finger is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The force is off for a moment, because this computer was too busy to guide the finger.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device was switched off, because this computer stood still. Start it again when you are ready.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device was switched off, because it no longer answers. Check its cable and start it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No face was found in this picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture is empty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture is not in 8-bit colour.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The search for faces was stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The face is cut off at the left edge of the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The face is cut off at the right edge of the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The face is cut off at the top edge of the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The face is cut off at the bottom edge of the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The right eye may be covered, so its contour may be wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The left eye may be covered, so its contour may be wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mouth may be covered, so its contour may be wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The outline may be covered, so its contour may be wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The edge of the right eye is faint, so its contour may be wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The edge of the left eye is faint, so its contour may be wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The edge of the mouth is faint, so its contour may be wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The edge of the outline is faint, so its contour may be wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This picture could not be worked on. It may be too large for this computer.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::Program</name>
    <message>
        <source>TouchPhoto</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feel a face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Listen to photographs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look after the album</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mend contours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Print a tactile sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lab</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::Questions</name>
    <message>
        <source>Shall TouchPhoto speak to you?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How fast shall it speak?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who uses this tablet most?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for a force device.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No force device was found. A finger on the screen is guided by sound instead.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A force device was found: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where are your photographs?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No, the words on the screen are enough</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>My screen reader shall speak</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Very slowly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slowly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At the usual speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Very fast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Somebody who listens and feels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Somebody who looks after the album</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on without a device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the folder %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In another folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I will say so later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Question %1 of %2. %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::RecordingList</name>
    <message>
        <source>Not said</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2, %3 of %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is the first one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is the last one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is number %2 of %3 now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deleted: %1. Undo brings it back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only a sound that is a file on this computer can be added.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Added: %1, %2. %3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::SettingsSession</name>
    <message>
        <source>No folder was chosen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The album has this folder already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the album&apos;s new folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 belongs to the album now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings. Go through them by Tab; each change is kept at once. Control Z takes the last one back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TouchPhoto speaks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>My screen reader speaks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody speaks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Very slow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Very fast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>who speaks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the speed of speech</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. This is how fast I speak.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the speed of recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings play at %1 times their speed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sounds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sounds on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sounds off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Somebody who listens and feels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Somebody who looks after the album</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yellow on black</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>who uses the tablet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the size of text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Text at %1 percent.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures may move.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing moves by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Beeps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spoken clock directions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what guides the finger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the strongest force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At most %1 newtons.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>brows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brows are felt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brows are not felt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the nose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The nose is felt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The nose is not felt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>irises</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Irises are felt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Irises are not felt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the folder that left the album</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 no longer belongs to the album. Its photographs and recordings stay where they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All settings are as they were at first. The album&apos;s folders stay.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to take back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taken back: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing leaves this computer: TouchPhoto opens no connection to any other.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These settings, in %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An index of the album, in %1 (%2). It can be thrown away at any time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Names, descriptions and recordings, beside the photographs in %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The photograph that you were at last: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The index is thrown away when TouchPhoto ends, and made anew from the photographs at the next start.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::Shell</name>
    <message>
        <source>Everywhere: Escape stops what sounds or moves, and then leads home. F1: this help. F2: the last sentence again. F3: voice on or off. Alt and Left: the page before.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::StartSession</name>
    <message>
        <source>Listen to photographs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One photograph after the other, with what was recorded for it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feel a face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The photograph that you were at last, under your finger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look after the album</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import photographs, name people, record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speech, colours, force, where photographs are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take a photograph</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not there yet: photographs of any camera can be imported</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Studies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not there yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TouchPhoto, start page. 1: %1. 2: %2. More below; F1 for help.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For researchers: guidance laws, their parameters, plots, recordings</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::TagPlayback</name>
    <message>
        <source>Next: %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::Take</name>
    <message>
        <source>Recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Being stored…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting for the microphone…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing heard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>soft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>good</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too loud</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recorder is still at work. Try again in a moment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paused.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Throw away what was recorded? It cannot be brought back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thrown away. Nothing was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kept. The recording is paused.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 It is saved.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tp::Trimming</name>
    <message>
        <source>%1 of %2 stay.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All of it stays.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All of it stays, so there is nothing to cut off. Move the begin or the end first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trimmed: %1 stay. Undo brings the rest back.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
