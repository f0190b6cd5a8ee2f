<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
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
</context>
</TS>
