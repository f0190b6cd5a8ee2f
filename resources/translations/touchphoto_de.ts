<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AimWords</name>
    <message>
        <source>Nobody is in view. Turn slowly to the left.</source>
        <translation>Niemand ist zu sehen. Drehen Sie sich langsam nach links.</translation>
    </message>
    <message>
        <source>Nobody is in view. Turn slowly to the right.</source>
        <translation>Niemand ist zu sehen. Drehen Sie sich langsam nach rechts.</translation>
    </message>
    <message>
        <source>Nobody is in view. Tilt slowly up.</source>
        <translation>Niemand ist zu sehen. Neigen Sie das Tablet langsam nach oben.</translation>
    </message>
    <message>
        <source>Nobody is in view. Tilt slowly down.</source>
        <translation>Niemand ist zu sehen. Neigen Sie das Tablet langsam nach unten.</translation>
    </message>
    <message>
        <source>a little left</source>
        <translation>etwas nach links</translation>
    </message>
    <message>
        <source>left</source>
        <translation>nach links</translation>
    </message>
    <message>
        <source>far left</source>
        <translation>weit nach links</translation>
    </message>
    <message>
        <source>a little right</source>
        <translation>etwas nach rechts</translation>
    </message>
    <message>
        <source>right</source>
        <translation>nach rechts</translation>
    </message>
    <message>
        <source>far right</source>
        <translation>weit nach rechts</translation>
    </message>
    <message>
        <source>a little up</source>
        <translation>etwas nach oben</translation>
    </message>
    <message>
        <source>up</source>
        <translation>nach oben</translation>
    </message>
    <message>
        <source>far up</source>
        <translation>weit nach oben</translation>
    </message>
    <message>
        <source>a little down</source>
        <translation>etwas nach unten</translation>
    </message>
    <message>
        <source>down</source>
        <translation>nach unten</translation>
    </message>
    <message>
        <source>far down</source>
        <translation>weit nach unten</translation>
    </message>
    <message>
        <source>a little closer</source>
        <translation>etwas näher</translation>
    </message>
    <message>
        <source>closer</source>
        <translation>näher</translation>
    </message>
    <message>
        <source>much closer</source>
        <translation>viel näher</translation>
    </message>
    <message>
        <source>a little back</source>
        <translation>etwas zurück</translation>
    </message>
    <message>
        <source>back</source>
        <translation>zurück</translation>
    </message>
    <message>
        <source>far back</source>
        <translation>weit zurück</translation>
    </message>
    <message>
        <source>a little clockwise</source>
        <translation>etwas im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>far clockwise</source>
        <translation>weit im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>a little anticlockwise</source>
        <translation>etwas gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>anticlockwise</source>
        <translation>gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>far anticlockwise</source>
        <translation>weit gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Too dark. More light on the face.</source>
        <translation>Zu dunkel. Mehr Licht aufs Gesicht.</translation>
    </message>
    <message>
        <source>The light is behind them.</source>
        <translation>Das Licht kommt von hinten.</translation>
    </message>
    <message>
        <source>Keep still.</source>
        <translation>Ruhig halten.</translation>
    </message>
    <message>
        <source>Eyes are shut.</source>
        <translation>Die Augen sind zu.</translation>
    </message>
    <message>
        <source>Good. Hold still.</source>
        <translation>Gut. Stillhalten.</translation>
    </message>
    <message>
        <source>Move the tablet: %1.</source>
        <translation>Bewegen Sie das Tablet: %1.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>All is well. Press Space to take another photograph.</source>
        <translation>Alles stimmt. Die Leertaste nimmt noch ein Foto auf.</translation>
    </message>
    <message numerus="yes">
        <source>%n face(s).</source>
        <translation>
            <numerusform>%n Gesicht.</numerusform>
            <numerusform>%n Gesichter.</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut off at the left edge.</source>
        <translation>Am linken Rand abgeschnitten.</translation>
    </message>
    <message>
        <source>Cut off at the right edge.</source>
        <translation>Am rechten Rand abgeschnitten.</translation>
    </message>
    <message>
        <source>Cut off at the upper edge.</source>
        <translation>Am oberen Rand abgeschnitten.</translation>
    </message>
    <message>
        <source>Cut off at the lower edge.</source>
        <translation>Am unteren Rand abgeschnitten.</translation>
    </message>
    <message>
        <source>One face in the middle</source>
        <translation>Ein Gesicht in der Mitte</translation>
    </message>
    <message>
        <source>One face by thirds</source>
        <translation>Ein Gesicht nach der Drittelregel</translation>
    </message>
    <message>
        <source>Head and shoulders</source>
        <translation>Kopf und Schultern</translation>
    </message>
    <message>
        <source>Everybody in view</source>
        <translation>Alle im Bild</translation>
    </message>
    <message numerus="yes">
        <source>%n more face(s)</source>
        <comment>at the end of a list of names</comment>
        <translation>
            <numerusform>%n weiteres Gesicht</numerusform>
            <numerusform>%n weitere Gesichter</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>BrowseButtons</name>
    <message>
        <source>Choose folders</source>
        <translation>Ordner auswählen</translation>
    </message>
    <message>
        <source>On the settings page</source>
        <translation>Auf der Seite „Einstellungen“</translation>
    </message>
    <message>
        <source>Import photographs</source>
        <translation>Fotos importieren</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play recordings</source>
        <translation>Aufnahmen abspielen</translation>
    </message>
    <message>
        <source>On the detail of a recording: only that one. Key: Enter</source>
        <translation>Auf dem Detail einer Aufnahme: nur diese. Taste: Eingabetaste</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Vorheriges</translation>
    </message>
    <message>
        <source>Photograph. Key: left arrow</source>
        <translation>Foto. Taste: Pfeil links</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Nächstes</translation>
    </message>
    <message>
        <source>Photograph. Key: right arrow</source>
        <translation>Foto. Taste: Pfeil rechts</translation>
    </message>
    <message>
        <source>Previous detail</source>
        <translation>Vorheriges Detail</translation>
    </message>
    <message>
        <source>Key: up arrow</source>
        <translation>Taste: Pfeil nach oben</translation>
    </message>
    <message>
        <source>Next detail</source>
        <translation>Nächstes Detail</translation>
    </message>
    <message>
        <source>People, recordings, descriptions, place and time. Key: down arrow</source>
        <translation>Personen, Aufnahmen, Beschreibungen, Ort und Zeit. Taste: Pfeil nach unten</translation>
    </message>
    <message>
        <source>Feel the face</source>
        <translation>Gesicht fühlen</translation>
    </message>
    <message>
        <source>Key: E</source>
        <translation>Taste: E</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>To the previous list. Key: Backspace</source>
        <translation>Zur vorherigen Liste. Taste: Rücktaste</translation>
    </message>
    <message>
        <source>All photographs</source>
        <translation>Alle Fotos</translation>
    </message>
    <message>
        <source>Key: A</source>
        <translation>Taste: A</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Key: S</source>
        <translation>Taste: S</translation>
    </message>
    <message>
        <source>Surprise me</source>
        <translation>Überraschen lassen</translation>
    </message>
    <message>
        <source>A random photograph. Key: R</source>
        <translation>Ein zufälliges Foto. Taste: R</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Key: P</source>
        <translation>Taste: P</translation>
    </message>
    <message>
        <source>Years</source>
        <translation>Jahre</translation>
    </message>
    <message>
        <source>Key: Y</source>
        <translation>Taste: Y</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Orte</translation>
    </message>
    <message>
        <source>Key: L</source>
        <translation>Taste: L</translation>
    </message>
    <message>
        <source>Keywords</source>
        <translation>Stichwörter</translation>
    </message>
    <message>
        <source>Key: K</source>
        <translation>Taste: K</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Langsamer</translation>
    </message>
    <message>
        <source>%1. Key: minus</source>
        <translation>%1. Taste: Minus</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Schneller</translation>
    </message>
    <message>
        <source>%1. Key: plus</source>
        <translation>%1. Taste: Plus</translation>
    </message>
    <message>
        <source>Where am I?</source>
        <translation>Wo bin ich?</translation>
    </message>
    <message>
        <source>Key: W</source>
        <translation>Taste: W</translation>
    </message>
    <message>
        <source>Look after it</source>
        <translation>Foto pflegen</translation>
    </message>
    <message>
        <source>Names, recordings and descriptions of this photograph. Key: C</source>
        <translation>Namen, Aufnahmen und Beschreibungen dieses Fotos. Taste: C</translation>
    </message>
</context>
<context>
    <name>BrowseKeys</name>
    <message>
        <source>Left, Right: photograph · Up, Down: details · Enter: recordings · Escape: stop · +, −: speed
Home, End: first, last · S: search · P: people · Y: years · L: places · K: keywords · R: surprise
A: all · Backspace: back · E: feel the face · C: look after it · W: where am I · H: keys</source>
        <translation>Links, Rechts: Foto · Auf, Ab: Details · Eingabetaste: Aufnahmen · Escape: anhalten · +, −: Tempo
Pos1, Ende: erstes, letztes · S: suchen · P: Personen · Y: Jahre · L: Orte · K: Stichwörter · R: überraschen
A: alle · Rücktaste: zurück · E: Gesicht fühlen · C: Foto pflegen · W: wo bin ich · H: Tasten</translation>
    </message>
</context>
<context>
    <name>CalibrationView</name>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Cancel the calibration</source>
        <translation>Kalibrierung abbrechen</translation>
    </message>
    <message>
        <source>Nothing is changed. Key: Escape</source>
        <translation>Nichts wird geändert. Taste: Escape</translation>
    </message>
</context>
<context>
    <name>CapturePanel</name>
    <message>
        <source>What to do</source>
        <translation>Was zu tun ist</translation>
    </message>
    <message>
        <source>Import photographs</source>
        <translation>Fotos importieren</translation>
    </message>
    <message>
        <source>Of another camera, into your album. Key: I</source>
        <translation>Von einer anderen Kamera in Ihr Album. Taste: I</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal versuchen</translation>
    </message>
    <message>
        <source>Key: R</source>
        <translation>Taste: R</translation>
    </message>
    <message>
        <source>What is in view?</source>
        <translation>Was ist zu sehen?</translation>
    </message>
    <message>
        <source>Says who is in the picture and what to do. Key: W</source>
        <translation>Sagt, wer im Bild ist und was zu tun ist. Taste: W</translation>
    </message>
    <message>
        <source>Aim</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Take it automatically when all is well</source>
        <translation>Automatisch aufnehmen, wenn alles stimmt</translation>
    </message>
    <message>
        <source>Back camera</source>
        <translation>Rückkamera</translation>
    </message>
    <message>
        <source>Front camera</source>
        <translation>Frontkamera</translation>
    </message>
    <message>
        <source>Key: C</source>
        <translation>Taste: C</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>This camera is simulated. Arrow keys turn it, Page up and Page down move it closer and back, Shift with left and right tilts it.</source>
        <translation>Diese Kamera ist simuliert. Die Pfeiltasten drehen sie, Bild auf und Bild ab bewegen sie näher und zurück, Umschalt mit links und rechts neigt sie.</translation>
    </message>
    <message>
        <source>Last photograph</source>
        <translation>Letztes Foto</translation>
    </message>
    <message>
        <source>Take the photograph</source>
        <translation>Foto aufnehmen</translation>
    </message>
    <message>
        <source>Also by a touch on the camera view. Key: Space</source>
        <translation>Auch durch Berühren des Kamerabilds. Taste: Leertaste</translation>
    </message>
    <message>
        <source>Finish the memo</source>
        <translation>Memo beenden</translation>
    </message>
    <message>
        <source>Record a memo</source>
        <translation>Memo aufnehmen</translation>
    </message>
    <message>
        <source>For the photograph that was taken last. Key: M</source>
        <translation>Für das zuletzt aufgenommene Foto. Taste: M</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Deletes the photograph again. Key: Control+Z</source>
        <translation>Löscht das Foto wieder. Taste: Strg+Z</translation>
    </message>
    <message>
        <source>Next frame of the burst</source>
        <translation>Nächstes Bild der Serie</translation>
    </message>
    <message>
        <source>Steps through the frames before and after it. Key: N; back: P</source>
        <translation>Geht die Bilder davor und danach durch. Taste: N; zurück: P</translation>
    </message>
    <message>
        <source>Keep this one too</source>
        <translation>Auch dieses behalten</translation>
    </message>
    <message>
        <source>Key: K</source>
        <translation>Taste: K</translation>
    </message>
    <message>
        <source>Space, or a touch on the camera view: take the photograph. Then M: record a memo, and M again to finish it. N, P: look through the other frames; K: keep one. Control+Z: undo.</source>
        <translation>Leertaste oder das Kamerabild berühren: Foto aufnehmen. Dann M: ein Memo aufnehmen, und noch einmal M beendet es. N, P: die anderen Bilder der Serie durchgehen; K: eines behalten. Strg+Z: rückgängig.</translation>
    </message>
    <message>
        <source>Keep the sound of the moment</source>
        <translation>Klang des Augenblicks mit aufnehmen</translation>
    </message>
    <message>
        <source>The microphone is on.</source>
        <translation>Das Mikrofon ist an.</translation>
    </message>
    <message>
        <source>1 to 4: aim at one face in the middle, one by thirds, head and shoulders, everybody. W: what is seen. S: take it automatically or not. A: with the sound of the moment or without. C: other camera. L: light. Escape: silence.</source>
        <translation>1 bis 4: Ziel: ein Gesicht in der Mitte, eines nach der Drittelregel, Kopf und Schultern, alle. W: was zu sehen ist. S: automatisch aufnehmen oder nicht. A: mit dem Klang des Augenblicks oder ohne. C: andere Kamera. L: Licht. Escape: Ruhe.</translation>
    </message>
    <message>
        <source>Point the camera at somebody and do what is said. A tone says where to move the camera: faster is nearer, high is up, and it comes from the side to move to. It rises when all is well. Where ticks are chosen as the guide, they are felt too: faster and stronger is nearer.</source>
        <translation>Richten Sie die Kamera auf jemanden und tun Sie, was gesagt wird. Ein Ton sagt, wohin die Kamera soll: schneller heißt näher, hoch heißt nach oben, und er kommt von der Seite, zu der sie soll. Er steigt, wenn alles stimmt. Sind Ticks als Führung gewählt, werden auch sie gefühlt: schneller und stärker heißt näher.</translation>
    </message>
</context>
<context>
    <name>CaptureSurface</name>
    <message>
        <source>Camera view</source>
        <translation>Kamerabild</translation>
    </message>
    <message>
        <source>The camera is starting.</source>
        <translation>Die Kamera startet.</translation>
    </message>
</context>
<context>
    <name>CarePage</name>
    <message>
        <source>Tab moves from control to control, the arrow keys from photograph to photograph, Enter opens one. Control+Z undoes the last step, Control+Shift+Z redoes it. Escape stops playback; it also ends a recording and keeps it.</source>
        <translation>Mit Tab gehen Sie von Bedienelement zu Bedienelement, mit den Pfeiltasten von Foto zu Foto, die Eingabetaste öffnet eines. Strg+Z macht den letzten Schritt rückgängig, Strg+Umschalt+Z wiederholt ihn. Escape hält die Wiedergabe an; eine laufende Aufnahme wird beendet und behalten.</translation>
    </message>
    <message>
        <source>Each row is a person. Tab moves from control to control, the arrow keys from row to row, Enter opens one. Type who it is, or press Y where a name is offered. On a face, Delete says that it is somebody else&apos;s. Control+Z undoes the last step. Escape leads back.</source>
        <translation>Jede Zeile ist eine Person. Mit Tab gehen Sie von Bedienelement zu Bedienelement, mit den Pfeiltasten von Zeile zu Zeile, die Eingabetaste öffnet eine. Geben Sie ein, wer das ist, oder drücken Sie Y, wenn ein Name angeboten wird. Auf einem Gesicht sagt Entf, dass es jemand anderes ist. Strg+Z macht den letzten Schritt rückgängig. Escape führt zurück.</translation>
    </message>
</context>
<context>
    <name>CareWords</name>
    <message>
        <source>Memo</source>
        <translation>Memo</translation>
    </message>
    <message>
        <source>Who it is</source>
        <translation>Wer das ist</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>Story</source>
        <translation>Geschichte</translation>
    </message>
    <message>
        <source>Background sounds</source>
        <translation>Umgebungsgeräusche</translation>
    </message>
    <message>
        <source>%1, about %2</source>
        <translation>%1, über %2</translation>
    </message>
    <message>
        <source>spoken by %1</source>
        <translation>gesprochen von %1</translation>
    </message>
    <message>
        <source>%1 seconds</source>
        <translation>%1 Sekunden</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s).</source>
        <translation>
            <numerusform>%n Aufnahme.</numerusform>
            <numerusform>%n Aufnahmen.</numerusform>
        </translation>
    </message>
    <message>
        <source>No description.</source>
        <translation>Keine Beschreibung.</translation>
    </message>
    <message>
        <source>%1 of %2 photographs, %3 of %4 megabytes</source>
        <translation>%1 von %2 Fotos, %3 von %4 Megabyte</translation>
    </message>
    <message>
        <source>%1, about %2 left</source>
        <translation>%1, noch etwa %2</translation>
    </message>
    <message>
        <source>The import was stopped before the first photograph.</source>
        <translation>Der Import wurde vor dem ersten Foto angehalten.</translation>
    </message>
    <message>
        <source>There is no photograph in what you chose.</source>
        <translation>In der Auswahl ist kein Foto.</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s) imported</source>
        <translation>
            <numerusform>%n Foto importiert</numerusform>
            <numerusform>%n Fotos importiert</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of them already in the album</source>
        <translation>
            <numerusform>%n davon schon im Album</numerusform>
            <numerusform>%n davon schon im Album</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n failed</source>
        <translation>
            <numerusform>%n fehlgeschlagen</numerusform>
            <numerusform>%n fehlgeschlagen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 The import was stopped; you can continue it later.</source>
        <translation>%1 Der Import wurde angehalten; Sie können ihn später fortsetzen.</translation>
    </message>
    <message>
        <source>Who is this?</source>
        <translation>Wer ist das?</translation>
    </message>
    <message>
        <source>Who is this? Perhaps %1.</source>
        <translation>Wer ist das? Vielleicht %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s)</source>
        <translation>
            <numerusform>%n Foto</numerusform>
            <numerusform>%n Fotos</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message numerus="yes">
        <source>%n to confirm</source>
        <translation>
            <numerusform>%n zu bestätigen</numerusform>
            <numerusform>%n zu bestätigen</numerusform>
        </translation>
    </message>
    <message>
        <source>Nobody was seen on two photographs yet.</source>
        <translation>Noch niemand ist auf zwei Fotos zu sehen.</translation>
    </message>
    <message numerus="yes">
        <source>%n person(s) without a name.</source>
        <translation>
            <numerusform>%n Person ohne Namen.</numerusform>
            <numerusform>%n Personen ohne Namen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Everybody here has a name.</source>
        <translation>Hier haben alle einen Namen.</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s) still to be looked at.</source>
        <translation>
            <numerusform>%n Foto ist noch durchzusehen.</numerusform>
            <numerusform>%n Fotos sind noch durchzusehen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n face(s) on one photograph only.</source>
        <translation>
            <numerusform>%n Gesicht auf nur einem Foto.</numerusform>
            <numerusform>%n Gesichter auf nur je einem Foto.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n face(s) too small, blurred, turned or covered to be compared.</source>
        <translation>
            <numerusform>%n Gesicht ist für einen Vergleich zu klein, unscharf, abgewandt oder verdeckt.</numerusform>
            <numerusform>%n Gesichter sind für einen Vergleich zu klein, unscharf, abgewandt oder verdeckt.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, to confirm</source>
        <translation>%1, zu bestätigen</translation>
    </message>
    <message numerus="yes">
        <source>%n face(s) to confirm.</source>
        <translation>
            <numerusform>%n Gesicht ist zu bestätigen.</numerusform>
            <numerusform>%n Gesichter sind zu bestätigen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of these with something new</source>
        <translation>
            <numerusform>davon %n mit etwas Neuem</numerusform>
            <numerusform>davon %n mit etwas Neuem</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>DescriptionPart</name>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>In one sentence (%1)</source>
        <translation>In einem Satz (%1)</translation>
    </message>
    <message>
        <source>%1 characters; a screen reader reads up to 250 at once.</source>
        <translation>%1 Zeichen; ein Screenreader liest bis zu 250 auf einmal.</translation>
    </message>
    <message>
        <source>%1 of 250 characters</source>
        <translation>%1 von 250 Zeichen</translation>
    </message>
    <message>
        <source>In more detail (%1)</source>
        <translation>Ausführlicher (%1)</translation>
    </message>
    <message>
        <source>%1 characters</source>
        <translation>%1 Zeichen</translation>
    </message>
    <message>
        <source>Save the description</source>
        <translation>Beschreibung speichern</translation>
    </message>
    <message>
        <source>The description is saved</source>
        <translation>Die Beschreibung ist gespeichert</translation>
    </message>
    <message>
        <source>It is also saved when you leave a field.</source>
        <translation>Sie wird auch gespeichert, wenn Sie ein Feld verlassen.</translation>
    </message>
    <message>
        <source>Suggested: %1</source>
        <translation>Vorschlag: %1</translation>
    </message>
    <message>
        <source>Use the suggestion</source>
        <translation>Vorschlag übernehmen</translation>
    </message>
    <message>
        <source>It becomes the description in one sentence, which you can change.</source>
        <translation>Der Vorschlag wird zur Beschreibung in einem Satz; Sie können sie ändern.</translation>
    </message>
</context>
<context>
    <name>DialogLoader</name>
    <message>
        <source>The file dialog is not installed. Drop files or folders on this window instead.</source>
        <translation>Der Dateidialog ist nicht installiert. Ziehen Sie stattdessen Dateien oder Ordner auf dieses Fenster.</translation>
    </message>
</context>
<context>
    <name>Duration</name>
    <message>
        <source>1 hour</source>
        <translation>1 Stunde</translation>
    </message>
    <message>
        <source>%1 hours</source>
        <translation>%1 Stunden</translation>
    </message>
    <message>
        <source>1 minute</source>
        <translation>1 Minute</translation>
    </message>
    <message>
        <source>%1 minutes</source>
        <translation>%1 Minuten</translation>
    </message>
    <message>
        <source>1 second</source>
        <translation>1 Sekunde</translation>
    </message>
    <message>
        <source>%1 seconds</source>
        <translation>%1 Sekunden</translation>
    </message>
</context>
<context>
    <name>ExperimentDialog</name>
    <message>
        <source>Open an experiment</source>
        <translation>Experiment öffnen</translation>
    </message>
    <message>
        <source>Experiments (%1)</source>
        <translation>Experimente (%1)</translation>
    </message>
    <message>
        <source>All files (%1)</source>
        <translation>Alle Dateien (%1)</translation>
    </message>
</context>
<context>
    <name>ExplorePage</name>
    <message>
        <source>The file dialog is not installed. Drop a photograph on this window instead.</source>
        <translation>Der Dateidialog ist nicht installiert. Ziehen Sie stattdessen ein Foto auf dieses Fenster.</translation>
    </message>
</context>
<context>
    <name>FaceTargets</name>
    <message>
        <source>Fits this face into the touch surface</source>
        <translation>Passt dieses Gesicht in die Tastfläche ein</translation>
    </message>
    <message>
        <source>Puts the finger there</source>
        <translation>Setzt den Finger dorthin</translation>
    </message>
</context>
<context>
    <name>FacesPart</name>
    <message>
        <source>Faces</source>
        <translation>Gesichter</translation>
    </message>
    <message>
        <source>Press to name this face</source>
        <translation>Drücken, um dieses Gesicht zu benennen</translation>
    </message>
    <message>
        <source>Who is face %1?</source>
        <translation>Wer ist Gesicht %1?</translation>
    </message>
    <message>
        <source>Nobody I know</source>
        <translation>Niemand, den ich kenne</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Leaves the face as it is.</source>
        <translation>Lässt das Gesicht, wie es ist.</translation>
    </message>
    <message>
        <source>Language of the name</source>
        <translation>Sprache des Namens</translation>
    </message>
    <message>
        <source>Same as the page</source>
        <translation>Wie die Seite</translation>
    </message>
    <message>
        <source>Yes, %1</source>
        <translation>Ja, %1</translation>
    </message>
    <message>
        <source>Key: Y</source>
        <translation>Taste: Y</translation>
    </message>
</context>
<context>
    <name>FingerMarks</name>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
</context>
<context>
    <name>FolderChooserView</name>
    <message>
        <source>Choose this folder</source>
        <translation>Diesen Ordner auswählen</translation>
    </message>
    <message>
        <source>Up one folder</source>
        <translation>Zum übergeordneten Ordner</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>GroupListPane</name>
    <message>
        <source>Back to the photographs</source>
        <translation>Zurück zu den Fotos</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
</context>
<context>
    <name>GroupPane</name>
    <message>
        <source>Back to the people</source>
        <translation>Zurück zu den Personen</translation>
    </message>
    <message>
        <source>Yes, this is %1</source>
        <translation>Ja, das ist %1</translation>
    </message>
    <message>
        <source>Names all of these faces. Key: Y</source>
        <translation>Benennt alle diese Gesichter. Taste: Y</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Gesichter</translation>
    </message>
    <message>
        <source>Not this person</source>
        <translation>Nicht diese Person</translation>
    </message>
    <message>
        <source>For the face that was chosen below. Key: Delete</source>
        <translation>Für das Gesicht, das unten ausgewählt ist. Taste: Entf</translation>
    </message>
    <message>
        <source>Open the photograph</source>
        <translation>Foto öffnen</translation>
    </message>
    <message>
        <source>Choose somebody to say who it is.</source>
        <translation>Wählen Sie jemanden aus, um zu sagen, wer das ist.</translation>
    </message>
</context>
<context>
    <name>ImportPart</name>
    <message>
        <source>Stop the import</source>
        <translation>Import anhalten</translation>
    </message>
    <message>
        <source>Import photographs…</source>
        <translation>Fotos importieren…</translation>
    </message>
    <message>
        <source>Or drop them on this window.</source>
        <translation>Oder ziehen Sie sie auf dieses Fenster.</translation>
    </message>
    <message>
        <source>Import a folder…</source>
        <translation>Ordner importieren…</translation>
    </message>
    <message>
        <source>Import into</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Continue the unfinished import</source>
        <translation>Unfertigen Import fortsetzen</translation>
    </message>
    <message>
        <source>Discard the unfinished import</source>
        <translation>Unfertigen Import verwerfen</translation>
    </message>
    <message>
        <source>What was imported stays.</source>
        <translation>Was schon importiert ist, bleibt.</translation>
    </message>
</context>
<context>
    <name>JoystickMeasuring</name>
    <message>
        <source>The stick will move by itself, a little to the right and back, then a little away from you and back. Let it stand free, and keep your hands off it.</source>
        <translation>Der Kraftstick bewegt sich gleich von selbst, ein wenig nach rechts und zurück, dann ein wenig von Ihnen weg und zurück. Lassen Sie ihn frei stehen und nehmen Sie die Hände von ihm.</translation>
    </message>
    <message>
        <source>Now it is clear which way the stick pulls. Hold its grip with a kitchen scale or a luggage scale, straight towards you: the stick pulls away from you. When the grip stands still, enter how many grams the scale shows.</source>
        <translation>Wohin der Kraftstick zieht, ist jetzt bekannt. Halten Sie seinen Griff mit einer Küchenwaage oder einer Kofferwaage gerade auf Sie zu: Der Kraftstick zieht von Ihnen weg. Wenn der Griff still steht, geben Sie ein, wie viel Gramm die Waage zeigt.</translation>
    </message>
    <message>
        <source>The stick is measured.</source>
        <translation>Der Kraftstick ist gemessen.</translation>
    </message>
    <message>
        <source>The stick did not stand still. Let go of it, check that nothing touches it, and measure again.</source>
        <translation>Der Kraftstick stand nicht still. Lassen Sie ihn los, achten Sie darauf, dass nichts ihn berührt, und messen Sie noch einmal.</translation>
    </message>
    <message>
        <source>The stick did not move. Check that its power supply is plugged in, keep your hands off it, and measure again.</source>
        <translation>Der Kraftstick hat sich nicht bewegt. Prüfen Sie, ob sein Netzteil angeschlossen ist, nehmen Sie die Hände von ihm, und messen Sie noch einmal.</translation>
    </message>
    <message>
        <source>The stick moved to one side of where it should have gone. It cannot be measured like that: check that nothing touches it and that it stands straight, and measure again.</source>
        <translation>Der Kraftstick ist von der Richtung abgewichen, in die er sich bewegen sollte. So kann er nicht gemessen werden: Achten Sie darauf, dass nichts ihn berührt und dass er gerade steht, und messen Sie noch einmal.</translation>
    </message>
    <message>
        <source>The stick did not come back the way it went. Check that nothing touches it, and measure again.</source>
        <translation>Der Kraftstick kam nicht so zurück, wie er gegangen war. Achten Sie darauf, dass nichts ihn berührt, und messen Sie noch einmal.</translation>
    </message>
    <message>
        <source>The stick was not weighed for three minutes, and its force is off. Measure it again when a scale is at hand.</source>
        <translation>Der Kraftstick wurde drei Minuten lang nicht gewogen; seine Kraft ist aus. Messen Sie ihn noch einmal, wenn eine Waage zur Hand ist.</translation>
    </message>
</context>
<context>
    <name>KeyHelp</name>
    <message>
        <source>Arrow keys, with Shift faster: move the hand. Tab: next feature. W: where am I. Z, Shift+Z: zoom in and out. Space: tour of the feature. T: tour of the face. G: guide. F: next face. N, Shift+N: next and previous photograph with a face. Enter: force on. Escape: stop. V: voice. O: open.</source>
        <translation>Pfeiltasten, mit Umschalt schneller: die Hand bewegen. Tab: nächstes Merkmal. W: wo bin ich. Z, Umschalt+Z: vergrößern und verkleinern. Leertaste: Rundgang um das Merkmal. T: Rundgang durch das Gesicht. G: Führung. F: nächstes Gesicht. N, Umschalt+N: nächstes und vorheriges Foto mit einem Gesicht. Eingabetaste: Kraft ein. Escape: anhalten. V: Stimme. O: öffnen.</translation>
    </message>
    <message>
        <source>Touch: one finger explores. Double tap: where am I. Double tap and hold: zoom to what is there, or out. Two-finger tap: stop. Two-finger double tap: tour. Three-finger tap: where am I. Two-finger swipe to the right or left: next or previous photograph with a face.</source>
        <translation>Berühren: Ein Finger erkundet. Doppeltippen: wo bin ich. Doppeltippen und halten: vergrößern, was dort ist, oder verkleinern. Mit zwei Fingern tippen: anhalten. Mit zwei Fingern doppeltippen: Rundgang. Mit drei Fingern tippen: wo bin ich. Mit zwei Fingern nach rechts oder links wischen: nächstes oder vorheriges Foto mit einem Gesicht.</translation>
    </message>
    <message>
        <source>In the picture: ring, the hand; disc, the finger; arrow, the pull of the line; small disc, where ticks lead.</source>
        <translation>Im Bild: Ring, die Hand; Scheibe, der Finger; Pfeil, der Zug der Linie; kleine Scheibe, wohin Ticks führen.</translation>
    </message>
</context>
<context>
    <name>LabControls</name>
    <message>
        <source>What is felt</source>
        <translation>Was zu fühlen ist</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Open photograph…</source>
        <translation>Foto öffnen…</translation>
    </message>
    <message>
        <source>Key: O. One can be dropped on the page too</source>
        <translation>Taste: O. Sie können auch eines auf die Seite ziehen</translation>
    </message>
    <message>
        <source>Law</source>
        <translation>Führungsgesetz</translation>
    </message>
    <message>
        <source>Stiffness K</source>
        <translation>Steifigkeit K</translation>
    </message>
    <message>
        <source>Range d</source>
        <translation>Reichweite d</translation>
    </message>
    <message>
        <source>Hysteresis at switches</source>
        <translation>Hysterese beim Wechsel</translation>
    </message>
    <message>
        <source>Blending at switches</source>
        <translation>Überblendung beim Wechsel</translation>
    </message>
    <message>
        <source>Corner cue</source>
        <translation>Eckenhinweis</translation>
    </message>
    <message>
        <source>Spacing of vertices</source>
        <translation>Abstand der Stützpunkte</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>Servo</translation>
    </message>
    <message>
        <source>Strongest force</source>
        <translation>Maximale Kraft</translation>
    </message>
    <message>
        <source>Damping across a line</source>
        <translation>Dämpfung quer zur Linie</translation>
    </message>
    <message>
        <source>Energy observer</source>
        <translation>Energiebeobachter</translation>
    </message>
    <message>
        <source>Limits of a real device</source>
        <translation>Grenzen eines echten Geräts</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Look for devices again</source>
        <translation>Erneut nach Geräten suchen</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Damping of the device</source>
        <translation>Dämpfung des Geräts</translation>
    </message>
    <message>
        <source>Dry friction</source>
        <translation>Trockene Reibung</translation>
    </message>
    <message>
        <source>Encoder step</source>
        <translation>Auflösung des Encoders</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Verzögerung</translation>
    </message>
    <message>
        <source>Grip of the hand</source>
        <translation>Griff der Hand</translation>
    </message>
    <message>
        <source>Damping of the hand</source>
        <translation>Dämpfung der Hand</translation>
    </message>
    <message>
        <source>Faults of the simulated device</source>
        <translation>Fehler des simulierten Geräts</translation>
    </message>
    <message>
        <source>Missing readings</source>
        <translation>Ausbleibende Messwerte</translation>
    </message>
    <message>
        <source>No readings at all</source>
        <translation>Gar keine Messwerte</translation>
    </message>
    <message>
        <source>Accepts no force</source>
        <translation>Nimmt keine Kraft an</translation>
    </message>
    <message>
        <source>Motors switch themselves off</source>
        <translation>Motoren schalten sich selbst ab</translation>
    </message>
    <message>
        <source>Unplugged</source>
        <translation>Abgezogen</translation>
    </message>
    <message>
        <source>Hang for 200 milliseconds</source>
        <translation>200 Millisekunden hängen</translation>
    </message>
    <message>
        <source>All parameters</source>
        <translation>Alle Parameter</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>Nichts rückgängig zu machen</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Key: Control+Z</source>
        <translation>Tasten: Strg+Z</translation>
    </message>
    <message>
        <source>Reset all parameters</source>
        <translation>Alle Parameter zurücksetzen</translation>
    </message>
    <message>
        <source>Can be undone</source>
        <translation>Kann rückgängig gemacht werden</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>In %1</source>
        <translation>In %1</translation>
    </message>
    <message>
        <source>Save the plots as a table</source>
        <translation>Diagramme als Tabelle speichern</translation>
    </message>
    <message>
        <source>CSV, with the parameters as JSON beside it</source>
        <translation>CSV, mit den Parametern als JSON daneben</translation>
    </message>
    <message>
        <source>No recordings yet.</source>
        <translation>Noch keine Aufnahmen.</translation>
    </message>
    <message>
        <source>Replay %1</source>
        <translation>%1 wiedergeben</translation>
    </message>
    <message>
        <source>Guidance</source>
        <translation>Führung</translation>
    </message>
    <message>
        <source>Set the strongest force of real devices</source>
        <translation>Maximale Kraft echter Geräte einstellen</translation>
    </message>
    <message>
        <source>Opens the settings</source>
        <translation>Öffnet die Einstellungen</translation>
    </message>
</context>
<context>
    <name>LabOpenDialog</name>
    <message>
        <source>Open photograph</source>
        <translation>Foto öffnen</translation>
    </message>
    <message>
        <source>Photographs (%1)</source>
        <translation>Fotos (%1)</translation>
    </message>
    <message>
        <source>All files (%1)</source>
        <translation>Alle Dateien (%1)</translation>
    </message>
</context>
<context>
    <name>LabPage</name>
    <message>
        <source>Start the servo</source>
        <translation>Servo starten</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Key: Space on the surface; Escape stops</source>
        <translation>Taste: Leertaste auf der Tastfläche; Escape hält an</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Aufnahme beenden</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Key: R</source>
        <translation>Taste: R</translation>
    </message>
    <message>
        <source>Where is the finger?</source>
        <translation>Wo ist der Finger?</translation>
    </message>
    <message>
        <source>Key: W</source>
        <translation>Taste: W</translation>
    </message>
    <message>
        <source>Read out the plots</source>
        <translation>Diagramme vorlesen</translation>
    </message>
    <message>
        <source>Key: P</source>
        <translation>Taste: P</translation>
    </message>
    <message>
        <source>On the surface, arrow keys move the hand and Space starts and stops the servo. R records, W says where the finger is, P reads out the plots, O opens a photograph, Control+Z undoes a change. Escape stops whatever is running.</source>
        <translation>Auf der Tastfläche bewegen die Pfeiltasten die Hand, die Leertaste startet und stoppt den Servo. R nimmt auf, W sagt, wo der Finger ist, P liest die Diagramme vor, O öffnet ein Foto, Strg+Z macht eine Änderung rückgängig. Escape hält an, was läuft.</translation>
    </message>
</context>
<context>
    <name>LabSurface</name>
    <message>
        <source>Arrow keys move the hand by 2 millimetres, with Shift by 10. Space starts and stops the servo.</source>
        <translation>Die Pfeiltasten bewegen die Hand um 2 Millimeter, mit Umschalt um 10. Die Leertaste startet und stoppt den Servo.</translation>
    </message>
</context>
<context>
    <name>LabWords</name>
    <message>
        <source>Position: nothing measured yet.</source>
        <translation>Position: noch nichts gemessen.</translation>
    </message>
    <message>
        <source>Force |F|: nothing measured yet.</source>
        <translation>Kraft |F|: noch nichts gemessen.</translation>
    </message>
    <message>
        <source>Energy: nothing measured yet.</source>
        <translation>Energie: noch nichts gemessen.</translation>
    </message>
    <message>
        <source>Lateness: nothing measured yet.</source>
        <translation>Verspätung: noch nichts gemessen.</translation>
    </message>
    <message>
        <source>%1 newtons per millimetre</source>
        <translation>%1 Newton pro Millimeter</translation>
    </message>
    <message>
        <source>%1 newtons</source>
        <translation>%1 Newton</translation>
    </message>
    <message>
        <source>%1 newton seconds per metre</source>
        <translation>%1 Newtonsekunden pro Meter</translation>
    </message>
    <message>
        <source>%1 grams</source>
        <translation>%1 Gramm</translation>
    </message>
    <message numerus="yes">
        <source>%n tick(s)</source>
        <translation>
            <numerusform>%n Takt</numerusform>
            <numerusform>%n Takte</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 percent</source>
        <translation>%1 Prozent</translation>
    </message>
    <message>
        <source>%1 of critical damping</source>
        <translation>%1 der kritischen Dämpfung</translation>
    </message>
    <message>
        <source>%1 millimetres</source>
        <translation>%1 Millimeter</translation>
    </message>
    <message>
        <source>%1, %2 of the middle</source>
        <translation>%1, %2 der Mitte</translation>
    </message>
    <message>
        <source>%1 mm left</source>
        <translation>%1 mm links</translation>
    </message>
    <message>
        <source>%1 mm right</source>
        <translation>%1 mm rechts</translation>
    </message>
    <message>
        <source>%1 mm below</source>
        <translation>%1 mm unterhalb</translation>
    </message>
    <message>
        <source>%1 mm above</source>
        <translation>%1 mm oberhalb</translation>
    </message>
    <message>
        <source>Position now x %1, y %2 mm; x from %3 to %4, y from %5 to %6.</source>
        <translation>Position jetzt x %1, y %2 mm; x von %3 bis %4, y von %5 bis %6.</translation>
    </message>
    <message>
        <source>Force |F| now %1 newtons, at most %2.</source>
        <translation>Kraft |F| jetzt %1 Newton, höchstens %2.</translation>
    </message>
    <message>
        <source>Energy given to the hand now %1 millijoules, from %2 to %3.</source>
        <translation>An die Hand abgegebene Energie jetzt %1 Millijoule, von %2 bis %3.</translation>
    </message>
    <message>
        <source>Ticks late by now %1 milliseconds, at most %2.</source>
        <translation>Takte jetzt um %1 Millisekunden verspätet, höchstens um %2.</translation>
    </message>
    <message>
        <source>Computed again, the forces differ by at most %1 newtons.</source>
        <translation>Neu berechnet, weichen die Kräfte um höchstens %1 Newton ab.</translation>
    </message>
    <message>
        <source>Its parameters are not beside it, so it was not computed again.</source>
        <translation>Ihre Parameter liegen nicht daneben, deshalb wurde sie nicht neu berechnet.</translation>
    </message>
    <message>
        <source>Its end was cut short and is left out.</source>
        <translation>Ihr Ende war abgeschnitten und wird weggelassen.</translation>
    </message>
</context>
<context>
    <name>LabelPart</name>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Who it is about</source>
        <translation>Über wen</translation>
    </message>
    <message>
        <source>About nobody in particular</source>
        <translation>Über niemand Bestimmtes</translation>
    </message>
    <message>
        <source>Who speaks</source>
        <translation>Wer spricht</translation>
    </message>
    <message>
        <source>Speaker not given</source>
        <translation>Keine Angabe, wer spricht</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
</context>
<context>
    <name>MeasuringView</name>
    <message>
        <source>Measuring the stick</source>
        <translation>Kraftstick messen</translation>
    </message>
    <message>
        <source>Grams on the scale</source>
        <translation>Gramm auf der Waage</translation>
    </message>
    <message>
        <source>Type, or use the slider below</source>
        <translation>Tippen oder den Regler unten benutzen</translation>
    </message>
    <message>
        <source>Grams, in steps of five</source>
        <translation>Gramm, in Fünferschritten</translation>
    </message>
    <message>
        <source>%1 grams</source>
        <translation>%1 Gramm</translation>
    </message>
    <message>
        <source>Use this weight</source>
        <translation>Dieses Gewicht verwenden</translation>
    </message>
    <message>
        <source>Cancel the measurement</source>
        <translation>Messung abbrechen</translation>
    </message>
    <message>
        <source>Nothing is changed. Key: Escape</source>
        <translation>Nichts wird geändert. Taste: Escape</translation>
    </message>
</context>
<context>
    <name>MendPage</name>
    <message>
        <source>Tab goes from point to point of the photograph&apos;s lines, Page Up and Page Down from feature to feature. Arrow keys move a point by one pixel, with Shift by ten, with Control by a fifth. A adds a point, Delete deletes it, C turns a corner into a smooth point. Control+Z undoes the last step, Control+S saves; leaving the page saves too.</source>
        <translation>Tab geht von Punkt zu Punkt der Linien auf dem Foto, Bild auf und Bild ab von Merkmal zu Merkmal. Pfeiltasten verschieben einen Punkt um ein Pixel, mit Umschalt um zehn, mit Strg um ein Fünftel. A fügt einen Punkt hinzu, Entf löscht ihn, C macht aus einer Ecke einen glatten Punkt. Strg+Z macht den letzten Schritt rückgängig, Strg+S speichert; auch beim Verlassen der Seite wird gespeichert.</translation>
    </message>
</context>
<context>
    <name>MendPanel</name>
    <message>
        <source>Mend contours</source>
        <translation>Konturen korrigieren</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Leaving this page saves too. Key: Control+S</source>
        <translation>Auch das Verlassen dieser Seite speichert. Tasten: Strg+S</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Key: Control+Z</source>
        <translation>Tasten: Strg+Z</translation>
    </message>
    <message>
        <source>Feature</source>
        <translation>Merkmal</translation>
    </message>
    <message>
        <source>Selected</source>
        <translation>Ausgewählt</translation>
    </message>
    <message>
        <source>%1: missing</source>
        <translation>%1: fehlt</translation>
    </message>
    <message>
        <source>%1 of the %2: %3</source>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>Previous point</source>
        <translation>Vorheriger Punkt</translation>
    </message>
    <message>
        <source>Key: Shift+Tab on the photograph</source>
        <translation>Tasten: Umschalt+Tab auf dem Foto</translation>
    </message>
    <message>
        <source>Next point</source>
        <translation>Nächster Punkt</translation>
    </message>
    <message>
        <source>Key: Tab on the photograph</source>
        <translation>Taste: Tab auf dem Foto</translation>
    </message>
    <message>
        <source>Move left</source>
        <translation>Nach links</translation>
    </message>
    <message>
        <source>Move right</source>
        <translation>Nach rechts</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>By one pixel of the photograph. Arrow keys: with Shift by ten, with Control by a fifth</source>
        <translation>Um ein Pixel des Fotos. Pfeiltasten: mit Umschalt um zehn, mit Strg um ein Fünftel</translation>
    </message>
    <message>
        <source>Move the whole feature</source>
        <translation>Ganzes Merkmal verschieben</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Punkt hinzufügen</translation>
    </message>
    <message>
        <source>After the selected one. Key: A. Or double-click beside a line</source>
        <translation>Hinter dem ausgewählten. Taste: A. Oder Doppelklick neben eine Linie</translation>
    </message>
    <message>
        <source>Delete the point</source>
        <translation>Punkt löschen</translation>
    </message>
    <message>
        <source>Key: Delete</source>
        <translation>Taste: Entf</translation>
    </message>
    <message>
        <source>Make it smooth</source>
        <translation>Glatt machen</translation>
    </message>
    <message>
        <source>Make it a corner</source>
        <translation>Zur Ecke machen</translation>
    </message>
    <message>
        <source>Key: C</source>
        <translation>Taste: C</translation>
    </message>
    <message>
        <source>Reset the feature</source>
        <translation>Merkmal zurücksetzen</translation>
    </message>
    <message>
        <source>Undoes the changes to this feature only</source>
        <translation>Macht nur die Änderungen an diesem Merkmal rückgängig</translation>
    </message>
    <message>
        <source>Remove the feature</source>
        <translation>Merkmal entfernen</translation>
    </message>
    <message>
        <source>It will not be felt</source>
        <translation>Es ist dann nicht mehr zu fühlen</translation>
    </message>
    <message>
        <source>Add the %1</source>
        <translation>Hinzufügen: %1</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Key: Plus</source>
        <translation>Taste: Plus</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Key: Minus</source>
        <translation>Taste: Minus</translation>
    </message>
    <message>
        <source>Whole photograph</source>
        <translation>Ganzes Foto</translation>
    </message>
    <message>
        <source>Key: 0</source>
        <translation>Taste: 0</translation>
    </message>
    <message>
        <source>This feature</source>
        <translation>Dieses Merkmal</translation>
    </message>
    <message>
        <source>Fits it into view. Key: Z</source>
        <translation>Zeigt es so groß wie möglich. Taste: Z</translation>
    </message>
    <message>
        <source>Show the force</source>
        <translation>Kraft zeigen</translation>
    </message>
    <message>
        <source>Shows what is felt</source>
        <translation>Zeigt, was zu fühlen ist</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Key: Control+Shift+Z</source>
        <translation>Tasten: Strg+Umschalt+Z</translation>
    </message>
    <message>
        <source>Add a face</source>
        <translation>Gesicht hinzufügen</translation>
    </message>
    <message>
        <source>One of the usual shape, for you to move into place</source>
        <translation>Eines in üblicher Form, zum Zurechtrücken</translation>
    </message>
    <message>
        <source>Discard all changes</source>
        <translation>Alle Änderungen verwerfen</translation>
    </message>
    <message>
        <source>The contours as they were when opened. Can be undone</source>
        <translation>Die Konturen wie beim Öffnen. Kann rückgängig gemacht werden</translation>
    </message>
    <message>
        <source>Keys on the photograph: Tab and Shift+Tab go from point to point; arrow keys move it by one pixel, with Shift by ten, with Control by a fifth; Page Up and Page Down change the feature; A adds a point, Delete deletes it, C makes it a corner or smooth, M moves the whole feature, F shows the force, plus and minus zoom, 0 shows all, Z this feature, W says where you are.</source>
        <translation>Tasten auf dem Foto: Tab und Umschalt+Tab gehen von Punkt zu Punkt; die Pfeiltasten verschieben ihn um ein Pixel, mit Umschalt um zehn, mit Strg um ein Fünftel; Bild auf und Bild ab wechseln das Merkmal; A fügt einen Punkt hinzu, Entf löscht ihn, C macht ihn zur Ecke oder glatt, M verschiebt das ganze Merkmal, F zeigt die Kraft, Plus und Minus zoomen, 0 zeigt alles, Z dieses Merkmal, W sagt, wo Sie sind.</translation>
    </message>
</context>
<context>
    <name>MendSurface</name>
    <message>
        <source>Contours</source>
        <translation>Konturen</translation>
    </message>
    <message>
        <source>Tab goes from point to point. Arrow keys move it by one pixel of the photograph, with Shift by ten, with Control by a fifth. Page Up and Page Down change the feature.</source>
        <translation>Tab geht von Punkt zu Punkt. Die Pfeiltasten verschieben ihn um ein Pixel des Fotos, mit Umschalt um zehn, mit Strg um ein Fünftel. Bild auf und Bild ab wechseln das Merkmal.</translation>
    </message>
    <message>
        <source>%1 across, %2 down</source>
        <translation>%1 von links, %2 von oben</translation>
    </message>
    <message>
        <source>No photograph yet.</source>
        <translation>Noch kein Foto.</translation>
    </message>
</context>
<context>
    <name>MendWords</name>
    <message>
        <source>Corner %1 of %2</source>
        <translation>Ecke %1 von %2</translation>
    </message>
    <message>
        <source>Point %1 of %2</source>
        <translation>Punkt %1 von %2</translation>
    </message>
    <message>
        <source>Bend %1 of %2</source>
        <comment>a control point beside the line</comment>
        <translation>Biegepunkt %1 von %2</translation>
    </message>
    <message>
        <source>%1 across, %2 down</source>
        <translation>%1 von links, %2 von oben</translation>
    </message>
    <message>
        <source>It feels as the program found it.</source>
        <translation>Es fühlt sich an, wie das Programm es gefunden hat.</translation>
    </message>
    <message>
        <source>A finger will not notice the difference from what the program found.</source>
        <translation>Ein Finger wird den Unterschied zur gefundenen Kontur nicht bemerken.</translation>
    </message>
    <message>
        <source>A finger notices the difference from what the program found on %1 % of the surface; there the force differs by up to %2 N.</source>
        <translation>Ein Finger bemerkt den Unterschied zur gefundenen Kontur auf %1 % der Fläche; dort weicht die Kraft um bis zu %2 N ab.</translation>
    </message>
</context>
<context>
    <name>NameField</name>
    <message>
        <source>Type, or choose below</source>
        <translation>Tippen oder unten auswählen</translation>
    </message>
</context>
<context>
    <name>NameList</name>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Key: Backspace</source>
        <translation>Taste: Rücktaste</translation>
    </message>
    <message>
        <source>A name, a place or any word</source>
        <translation>Ein Name, ein Ort oder irgendein Wort</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>To the previous row. Key: up arrow</source>
        <translation>Zur vorherigen Zeile. Taste: Pfeil nach oben</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>To the next row. Key: down arrow</source>
        <translation>Zur nächsten Zeile. Taste: Pfeil nach unten</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>The row read out last. Key: Enter</source>
        <translation>Die zuletzt vorgelesene Zeile. Taste: Eingabetaste</translation>
    </message>
    <message>
        <source>Letters to type with</source>
        <translation>Buchstabenfeld</translation>
    </message>
    <message>
        <source>Delete the last letter</source>
        <translation>Letzten Buchstaben löschen</translation>
    </message>
</context>
<context>
    <name>OpenDialog</name>
    <message>
        <source>Open photograph</source>
        <translation>Foto öffnen</translation>
    </message>
    <message>
        <source>Photographs (%1)</source>
        <translation>Fotos (%1)</translation>
    </message>
    <message>
        <source>All files (%1)</source>
        <translation>Alle Dateien (%1)</translation>
    </message>
</context>
<context>
    <name>PhotoListPane</name>
    <message>
        <source>Photographs of the album</source>
        <translation>Fotos des Albums</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Reihenfolge</translation>
    </message>
    <message>
        <source>Newest first</source>
        <translation>Neueste zuerst</translation>
    </message>
    <message>
        <source>Check these first</source>
        <translation>Auffällige zuerst</translation>
    </message>
    <message numerus="yes">
        <source>Checking faces, %n photograph(s) left…</source>
        <translation>
            <numerusform>Gesichter werden geprüft, noch %n Foto…</numerusform>
            <numerusform>Gesichter werden geprüft, noch %n Fotos…</numerusform>
        </translation>
    </message>
    <message>
        <source>There are no photographs in the album yet.</source>
        <translation>Im Album sind noch keine Fotos.</translation>
    </message>
    <message>
        <source>The album has no folder yet. You will be asked for one when you import.</source>
        <translation>Das Album hat noch keinen Ordner. Beim Importieren werden Sie nach einem gefragt.</translation>
    </message>
    <message>
        <source>People…</source>
        <translation>Personen…</translation>
    </message>
    <message>
        <source>Says once who somebody is, for all photographs.</source>
        <translation>Einmal sagen, wer jemand ist, für alle Fotos.</translation>
    </message>
</context>
<context>
    <name>PhotoPane</name>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Left and right arrow: other photographs. Up and down: details. Enter: recordings.</source>
        <translation>Pfeil links und rechts: andere Fotos. Auf und ab: Details. Eingabetaste: Aufnahmen.</translation>
    </message>
    <message>
        <source>Back to the photographs</source>
        <translation>Zurück zu den Fotos</translation>
    </message>
    <message>
        <source>The photograph</source>
        <translation>Das Foto</translation>
    </message>
    <message>
        <source>Mend contours…</source>
        <translation>Konturen korrigieren…</translation>
    </message>
    <message>
        <source>Print a tactile sheet…</source>
        <translation>Tastblatt drucken…</translation>
    </message>
    <message>
        <source>Delete the photograph</source>
        <translation>Foto löschen</translation>
    </message>
    <message>
        <source>With everything that belongs to it. Undo brings it back.</source>
        <translation>Mit allem, was dazugehört. „Rückgängig“ bringt es zurück.</translation>
    </message>
    <message>
        <source>Choose a photograph to look after it.</source>
        <translation>Wählen Sie ein Foto aus, um es zu pflegen.</translation>
    </message>
</context>
<context>
    <name>PhotoWords</name>
    <message numerus="yes">
        <source>%n face(s)</source>
        <translation>
            <numerusform>%n Gesicht</numerusform>
            <numerusform>%n Gesichter</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more face(s)</source>
        <translation>
            <numerusform>%n weiteres Gesicht</numerusform>
            <numerusform>%n weitere Gesichter</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <comment>between who, when and where</comment>
        <translation>, </translation>
    </message>
    <message>
        <source>%1; no recordings yet.</source>
        <translation>%1; noch keine Aufnahmen.</translation>
    </message>
    <message numerus="yes">
        <source>%1; %n recording(s).</source>
        <translation>
            <numerusform>%1; %n Aufnahme.</numerusform>
            <numerusform>%1; %n Aufnahmen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n face(s) without a name.</source>
        <translation>
            <numerusform>%n Gesicht ohne Namen.</numerusform>
            <numerusform>%n Gesichter ohne Namen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Recording %1 of %2: %3, %4.</source>
        <translation>Aufnahme %1 von %2: %3, %4.</translation>
    </message>
    <message>
        <source>Place: %1.</source>
        <translation>Ort: %1.</translation>
    </message>
    <message>
        <source>Place: %1 degrees north, %2 degrees east.</source>
        <translation>Ort: %1 Grad Nord, %2 Grad Ost.</translation>
    </message>
    <message>
        <source>Taken: %1.</source>
        <translation>Aufgenommen: %1.</translation>
    </message>
    <message>
        <source>Keywords: %1.</source>
        <translation>Stichwörter: %1.</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between keywords</comment>
        <translation>, </translation>
    </message>
    <message>
        <source>File: %1.</source>
        <translation>Datei: %1.</translation>
    </message>
    <message>
        <source>memo</source>
        <translation>Memo</translation>
    </message>
    <message>
        <source>memo by %1</source>
        <translation>Memo von %1</translation>
    </message>
    <message>
        <source>about a person</source>
        <translation>über eine Person</translation>
    </message>
    <message>
        <source>about a person, by %1</source>
        <translation>über eine Person, von %1</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>über %1</translation>
    </message>
    <message>
        <source>about %1, by %2</source>
        <translation>über %1, von %2</translation>
    </message>
    <message>
        <source>about the place</source>
        <translation>über den Ort</translation>
    </message>
    <message>
        <source>about the place, by %1</source>
        <translation>über den Ort, von %1</translation>
    </message>
    <message>
        <source>story</source>
        <translation>Geschichte</translation>
    </message>
    <message>
        <source>story by %1</source>
        <translation>Geschichte von %1</translation>
    </message>
    <message>
        <source>background sounds</source>
        <translation>Umgebungsgeräusche</translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s)</source>
        <translation>
            <numerusform>%n Stunde</numerusform>
            <numerusform>%n Stunden</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n minute(s)</source>
        <translation>
            <numerusform>%n Minute</numerusform>
            <numerusform>%n Minuten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n second(s)</source>
        <translation>
            <numerusform>%n Sekunde</numerusform>
            <numerusform>%n Sekunden</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>the month&apos;s name and the year</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>a day and a time</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>No recordings yet.</source>
        <translation>Noch keine Aufnahmen.</translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s).</source>
        <translation>
            <numerusform>%n Aufnahme.</numerusform>
            <numerusform>%n Aufnahmen.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>two sentences</comment>
        <translation>%1 %2</translation>
    </message>
</context>
<context>
    <name>PhotosDialog</name>
    <message>
        <source>Import photographs</source>
        <translation>Fotos importieren</translation>
    </message>
    <message>
        <source>Photographs and bundles (%1)</source>
        <translation>Fotos und Pakete (%1)</translation>
    </message>
    <message>
        <source>All files (%1)</source>
        <translation>Alle Dateien (%1)</translation>
    </message>
</context>
<context>
    <name>PrintPage</name>
    <message>
        <source>Choose the paper and the face, then save the sheet as PDF for a printer or as SVG for a drawing program. Swell paper and embossers raise its black lines and dots.</source>
        <translation>Wählen Sie Papier und Gesicht; speichern Sie das Tastblatt dann als PDF für einen Drucker oder als SVG für ein Zeichenprogramm. Schwellpapier und Punktschriftdrucker lassen die schwarzen Linien und Punkte hervortreten.</translation>
    </message>
    <message>
        <source>The sheet, %1</source>
        <translation>Das Tastblatt, %1</translation>
    </message>
    <message>
        <source>No sheet yet</source>
        <translation>Noch kein Tastblatt</translation>
    </message>
    <message>
        <source>No photograph</source>
        <translation>Kein Foto</translation>
    </message>
    <message>
        <source>Looking for faces</source>
        <translation>Gesichter werden gesucht</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Turn by 90 degrees</source>
        <translation>Um 90 Grad drehen</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Wer</translation>
    </message>
    <message>
        <source>Name in print</source>
        <translation>Name in Schwarzschrift</translation>
    </message>
    <message>
        <source>Save as PDF</source>
        <translation>Als PDF speichern</translation>
    </message>
    <message>
        <source>Save as SVG</source>
        <translation>Als SVG speichern</translation>
    </message>
</context>
<context>
    <name>RecordingsPart</name>
    <message>
        <source>Recordings</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>No recordings yet.</source>
        <translation>Noch keine Aufnahmen.</translation>
    </message>
    <message>
        <source>Selected: %1</source>
        <translation>Ausgewählt: %1</translation>
    </message>
    <message>
        <source>Stop playing</source>
        <translation>Wiedergabe anhalten</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Play earlier</source>
        <translation>Früher abspielen</translation>
    </message>
    <message>
        <source>Moves it up in the list.</source>
        <translation>Rückt sie in der Liste nach oben.</translation>
    </message>
    <message>
        <source>Play later</source>
        <translation>Später abspielen</translation>
    </message>
    <message>
        <source>Moves it down in the list.</source>
        <translation>Rückt sie in der Liste nach unten.</translation>
    </message>
    <message>
        <source>Record again</source>
        <translation>Neu aufnehmen</translation>
    </message>
    <message>
        <source>The old one goes to the trash when the new one is kept.</source>
        <translation>Die alte kommt in den Papierkorb, wenn die neue behalten wird.</translation>
    </message>
    <message>
        <source>Close the label</source>
        <translation>Angaben schließen</translation>
    </message>
    <message>
        <source>Label…</source>
        <translation>Angaben…</translation>
    </message>
    <message>
        <source>Kind, person, speaker and language.</source>
        <translation>Art, Person, wer spricht und Sprache.</translation>
    </message>
    <message>
        <source>Delete the recording</source>
        <translation>Aufnahme löschen</translation>
    </message>
    <message>
        <source>Undo brings it back.</source>
        <translation>„Rückgängig“ bringt sie zurück.</translation>
    </message>
</context>
<context>
    <name>RunView</name>
    <message>
        <source>This is tried out. Nothing is kept.</source>
        <translation>Das ist ein Probelauf. Nichts wird gespeichert.</translation>
    </message>
    <message>
        <source>I agree</source>
        <translation>Ich bin einverstanden</translation>
    </message>
    <message>
        <source>Key: Enter</source>
        <translation>Taste: Eingabetaste</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Start the trial</source>
        <translation>Durchgang beginnen</translation>
    </message>
    <message>
        <source>End the trial</source>
        <translation>Durchgang beenden</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Key: Space</source>
        <translation>Taste: Leertaste</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>The force is off at once. Key: P</source>
        <translation>Die Kraft ist sofort aus. Taste: P</translation>
    </message>
    <message>
        <source>I do not agree</source>
        <translation>Ich bin nicht einverstanden</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Studie beenden</translation>
    </message>
    <message>
        <source>Key: Escape</source>
        <translation>Taste: Escape</translation>
    </message>
</context>
<context>
    <name>Sentence</name>
    <message>
        <source>&quot;%1&quot; cannot be added to a face; brows, nose and irises can.</source>
        <translation>„%1“ kann einem Gesicht nicht hinzugefügt werden; Brauen, Nase und Iris gehen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be changed: %2</source>
        <translation>„%1“ kann nicht geändert werden: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be moved: %2</source>
        <translation>„%1“ kann nicht verschoben werden: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read.</source>
        <translation>„%1“ kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be renamed: %2</source>
        <translation>„%1“ kann nicht umbenannt werden: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be restored and stays in the trash: %2</source>
        <translation>„%1“ kann nicht zurückgebracht werden und bleibt im Papierkorb: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be restored, because another file has its place now. Move that one away first.</source>
        <translation>„%1“ kann nicht zurückgebracht werden, weil jetzt eine andere Datei an der Stelle liegt. Verschieben Sie zuerst diese.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be added: %2</source>
        <translation>„%1“ kann nicht hinzugefügt werden: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be trimmed: %2</source>
        <translation>„%1“ kann nicht gekürzt werden: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be trimmed: the part must begin before it ends.</source>
        <translation>„%1“ kann nicht gekürzt werden: Der Teil muss beginnen, bevor er endet.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be used: %2</source>
        <translation>„%1“ kann nicht verwendet werden: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; changed meanwhile.</source>
        <translation>„%1“ hat sich inzwischen geändert.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a folder, not a file.</source>
        <translation>„%1“ ist ein Ordner, keine Datei.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a folder.</source>
        <translation>„%1“ ist ein Ordner.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a link; it is left alone.</source>
        <translation>„%1“ ist eine Verknüpfung und bleibt unangetastet.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a file.</source>
        <translation>„%1“ ist keine Datei.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a file; it is left alone.</source>
        <translation>„%1“ ist keine Datei und bleibt unangetastet.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a folder in the album.</source>
        <translation>„%1“ ist kein Ordner im Album.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not in the album &quot;%2&quot;.</source>
        <translation>„%1“ ist nicht im Album „%2“.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; already exists, so nothing was moved.</source>
        <translation>„%1“ gibt es schon, deshalb wurde nichts verschoben.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; exists, so it stays on the list.</source>
        <translation>„%1“ gibt es und bleibt deshalb auf der Liste.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not deleted, because it is not in the album &quot;%2&quot;.</source>
        <translation>„%1“ wurde nicht gelöscht, weil es nicht im Album „%2“ ist.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not imported: %2</source>
        <translation>„%1“ wurde nicht importiert: %2</translation>
    </message>
    <message>
        <source>%1 Bring the photograph back first, then its recording.</source>
        <translation>%1 Bringen Sie zuerst das Foto zurück, dann seine Aufnahme.</translation>
    </message>
    <message>
        <source>%1 It was left as it is.</source>
        <translation>%1 Alles blieb, wie es ist.</translation>
    </message>
    <message>
        <source>%1 Some photographs kept the new name: %2</source>
        <translation>%1 Einige Fotos behielten den neuen Namen: %2</translation>
    </message>
    <message>
        <source>%1 became %2</source>
        <translation>%1 heißt jetzt %2</translation>
    </message>
    <message>
        <source>%1 cannot be used: %2</source>
        <translation>%1 kann nicht verwendet werden: %2</translation>
    </message>
    <message>
        <source>%1 has a transform that cannot be read: &quot;%2&quot;.</source>
        <translation>%1 hat eine Transformation, die nicht gelesen werden kann: „%2“.</translation>
    </message>
    <message>
        <source>%1 in &quot;%2&quot;</source>
        <translation>%1 auf „%2“</translation>
    </message>
    <message>
        <source>%1 is being made.</source>
        <translation>%1 wird gerade angelegt.</translation>
    </message>
    <message>
        <source>%1 is moved by its style, which is not understood; give it a transform attribute instead.</source>
        <translation>%1 wird durch seinen Stil verschoben; das wird nicht verstanden. Geben Sie stattdessen ein transform-Attribut an.</translation>
    </message>
    <message>
        <source>%1 is not between %2 and %3.</source>
        <translation>%1 liegt nicht zwischen %2 und %3.</translation>
    </message>
    <message>
        <source>%1 reaches beyond what can be computed with.</source>
        <translation>%1 reicht weiter, als gerechnet werden kann.</translation>
    </message>
    <message>
        <source>%1 was &quot;%2&quot; in another copy; it is &quot;%3&quot; now.</source>
        <translation>%1 war in einer anderen Kopie „%2“; jetzt gilt „%3“.</translation>
    </message>
    <message>
        <source>%1 was added</source>
        <translation>%1 wurde hinzugefügt</translation>
    </message>
    <message>
        <source>%1 was deleted</source>
        <translation>%1 wurde gelöscht</translation>
    </message>
    <message>
        <source>%1 was described</source>
        <translation>%1 wurde beschrieben</translation>
    </message>
    <message>
        <source>%1 was labelled</source>
        <translation>%1 wurde beschriftet</translation>
    </message>
    <message>
        <source>%1 was not finished and cannot be repaired: %2</source>
        <translation>%1 wurde nicht beendet und lässt sich nicht reparieren: %2</translation>
    </message>
    <message>
        <source>%1 was not finished and held no sound.</source>
        <translation>%1 wurde nicht beendet und enthielt keinen Ton.</translation>
    </message>
    <message>
        <source>%1 was not finished; what was recorded is in &quot;%2&quot;.</source>
        <translation>%1 wurde nicht beendet; was aufgenommen wurde, ist in „%2“.</translation>
    </message>
    <message>
        <source>%1 was trimmed</source>
        <translation>%1 wurde gekürzt</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>A motor of the force pad took too much current. Check that nothing blocks the knob.</source>
        <translation>Ein Motor des Kraftpads zog zu viel Strom. Prüfen Sie, ob etwas den Knopf blockiert.</translation>
    </message>
    <message>
        <source>A person needs a name before it can be recorded.</source>
        <translation>Eine Person braucht einen Namen, bevor er aufgenommen werden kann.</translation>
    </message>
    <message>
        <source>A person needs a name, and a different one than before.</source>
        <translation>Eine Person braucht einen Namen, und einen anderen als bisher.</translation>
    </message>
    <message>
        <source>A picture and the touch surface both need a width and a height above zero.</source>
        <translation>Bild und Tastfläche brauchen beide eine Breite und eine Höhe über null.</translation>
    </message>
    <message>
        <source>A recording is listed as %1, which is not a file name; it is left out.</source>
        <translation>Eine Aufnahme ist als %1 aufgeführt, was kein Dateiname ist; sie wird ausgelassen.</translation>
    </message>
    <message>
        <source>A tactile sheet is written as .pdf or .svg, not as &quot;%1&quot;.</source>
        <translation>Ein Tastblatt wird als .pdf oder .svg geschrieben, nicht als „%1“.</translation>
    </message>
    <message>
        <source>Another driver holds the %1. Remove the driver that its maker installed and start this computer again.</source>
        <translation>Ein anderer Treiber belegt dieses Gerät: %1. Entfernen Sie den Treiber, den sein Hersteller installiert hat, und starten Sie diesen Computer neu.</translation>
    </message>
    <message>
        <source>Another driver of the system holds the %1 and does not let go of it. Unplug the device, unload that driver and plug the device in again.</source>
        <translation>Ein anderer Treiber des Systems belegt dieses Gerät und gibt es nicht frei: %1. Ziehen Sie das Gerät ab, entladen Sie den Treiber und schließen Sie das Gerät wieder an.</translation>
    </message>
    <message>
        <source>Another driver of the system holds the %1. Unplug the device and plug it in again; if that does not help, its kernel must have the hidraw driver.</source>
        <translation>Ein anderer Treiber des Systems belegt dieses Gerät: %1. Ziehen Sie das Gerät ab und schließen Sie es wieder an; hilft das nicht, braucht der Systemkern den Treiber hidraw.</translation>
    </message>
    <message>
        <source>Another program is using &quot;%1&quot;; try again.</source>
        <translation>Ein anderes Programm benutzt gerade „%1“; versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Another program uses the %1. Close that program and try again.</source>
        <translation>Ein anderes Programm benutzt dieses Gerät: %1. Schließen Sie das Programm und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Calibration needs at least three marks that do not lie on one line; touch more marks.</source>
        <translation>Die Kalibrierung braucht mindestens drei Marken, die nicht auf einer Linie liegen; berühren Sie weitere Marken.</translation>
    </message>
    <message>
        <source>Hysteresis and blending are two answers to the same jump; choose one of them.</source>
        <translation>Hysterese und Überblendung sind zwei Antworten auf denselben Sprung; wählen Sie eine davon.</translation>
    </message>
    <message>
        <source>Hysteresis, blending and corner cue belong to the exact law, not to the published one.</source>
        <translation>Hysterese, Überblendung und Eckenhinweis gehören zum exakten Führungsgesetz, nicht zum veröffentlichten.</translation>
    </message>
    <message>
        <source>It is damaged; only the first %1 of %2 could be read.</source>
        <translation>Die Datei ist beschädigt; nur die ersten %1 von %2 konnten gelesen werden.</translation>
    </message>
    <message>
        <source>It names a file in a way that TouchPhoto does not write.</source>
        <translation>Sie nennt eine Datei auf eine Weise, die TouchPhoto nicht schreibt.</translation>
    </message>
    <message>
        <source>No face was found in this picture.</source>
        <translation>Auf diesem Bild wurde kein Gesicht gefunden.</translation>
    </message>
    <message>
        <source>Nothing was deleted, because the trash cannot be created: %1</source>
        <translation>Es wurde nichts gelöscht, weil der Papierkorb nicht angelegt werden kann: %1</translation>
    </message>
    <message>
        <source>Nothing was deleted, because the trash cannot be written to: %1</source>
        <translation>Es wurde nichts gelöscht, weil in den Papierkorb nicht geschrieben werden kann: %1</translation>
    </message>
    <message>
        <source>Nothing was deleted: %1</source>
        <translation>Es wurde nichts gelöscht: %1</translation>
    </message>
    <message>
        <source>Nothing was named that could be deleted.</source>
        <translation>Es wurde nichts genannt, was gelöscht werden könnte.</translation>
    </message>
    <message>
        <source>Pictures other than JPEG need the library %1 (Debian: %2), which is not installed: install it or save the picture as JPEG.</source>
        <translation>Andere Bilder als JPEG brauchen die Bibliothek %1 (Debian: %2), die hier fehlt: Installieren Sie sie, oder speichern Sie das Bild als JPEG.</translation>
    </message>
    <message>
        <source>Qt&apos;s driver for SQLite is not installed; without it there is no album. On Debian it is the package libqt6sql6-sqlite.</source>
        <translation>Der Qt-Treiber für SQLite ist nicht installiert; ohne ihn gibt es kein Album. Unter Debian ist es das Paket libqt6sql6-sqlite.</translation>
    </message>
    <message>
        <source>Stiffness and range of the guidance must both be numbers above zero.</source>
        <translation>Steifigkeit und Reichweite der Führung müssen beide Zahlen über null sein.</translation>
    </message>
    <message>
        <source>The %1 &quot;%2&quot;</source>
        <translation>Das Element %1 „%2“</translation>
    </message>
    <message>
        <source>The %1 could not be opened. Unplug it, plug it in again and try once more.</source>
        <translation>Dieses Gerät konnte nicht geöffnet werden: %1. Ziehen Sie es ab, schließen Sie es wieder an und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The %1 file is damaged.</source>
        <translation>Die %1-Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>The %1 has the wrong driver. In the Device Manager choose Update driver, then &quot;USB Input Device&quot;.</source>
        <translation>Dieses Gerät hat den falschen Treiber: %1. Wählen Sie im Geräte-Manager „Treiber aktualisieren“, dann „USB-Eingabegerät“.</translation>
    </message>
    <message>
        <source>The %1 has the wrong driver. In the Device Manager choose Update driver, then &quot;WinUsb Device&quot;.</source>
        <translation>Dieses Gerät hat den falschen Treiber: %1. Wählen Sie im Geräte-Manager „Treiber aktualisieren“, dann „WinUsb-Gerät“.</translation>
    </message>
    <message>
        <source>The %1 may be covered, so its contour may be wrong.</source>
        <translation>Vielleicht ist ein Teil %1 verdeckt, die Kontur könnte deshalb falsch sein.</translation>
    </message>
    <message>
        <source>The %1 was unplugged. Plug it in again.</source>
        <translation>Dieses Gerät wurde abgezogen: %1. Schließen Sie es wieder an.</translation>
    </message>
    <message>
        <source>The %1 without an id</source>
        <translation>Das Element %1 ohne id</translation>
    </message>
    <message>
        <source>The JPEG file is cut short: a part of the picture is missing.</source>
        <translation>Die JPEG-Datei ist abgeschnitten: Ein Teil des Bildes fehlt.</translation>
    </message>
    <message>
        <source>The JPEG file is damaged.</source>
        <translation>Die JPEG-Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>The PNG file is cut short: a part of the picture is missing.</source>
        <translation>Die PNG-Datei ist abgeschnitten: Ein Teil des Bildes fehlt.</translation>
    </message>
    <message>
        <source>The PNG file is damaged.</source>
        <translation>Die PNG-Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>The WebP file is cut short: a part of the picture is missing.</source>
        <translation>Die WebP-Datei ist abgeschnitten: Ein Teil des Bildes fehlt.</translation>
    </message>
    <message>
        <source>The album&apos;s index %1; it was set aside as &quot;%2&quot; and is rebuilt. The photographs are not affected.</source>
        <translation>Der Index des Albums %1; er wurde als „%2“ beiseitegelegt und wird neu aufgebaut. Die Fotos bleiben davon unberührt.</translation>
    </message>
    <message>
        <source>The album&apos;s index cannot be kept in &quot;%1&quot;; it is held in memory and rebuilt at every start: %2</source>
        <translation>Der Index des Albums kann nicht in „%1“ gehalten werden; er liegt im Arbeitsspeicher und wird bei jedem Start neu aufgebaut: %2</translation>
    </message>
    <message>
        <source>The album&apos;s index cannot be created: %1.</source>
        <translation>Der Index des Albums kann nicht angelegt werden: %1.</translation>
    </message>
    <message>
        <source>The album&apos;s index cannot be used: %1.</source>
        <translation>Der Index des Albums kann nicht benutzt werden: %1.</translation>
    </message>
    <message>
        <source>The album&apos;s index cannot grow: the disk is full.</source>
        <translation>Der Index des Albums kann nicht wachsen: Der Datenträger ist voll.</translation>
    </message>
    <message>
        <source>The album&apos;s index is damaged; it is rebuilt when the album is next opened. The photographs are not affected.</source>
        <translation>Der Index des Albums ist beschädigt; er wird neu aufgebaut, wenn das Album das nächste Mal geöffnet wird. Die Fotos bleiben davon unberührt.</translation>
    </message>
    <message>
        <source>The braille table %1 was not found; names cannot be written in braille. Install the package liblouis-data.</source>
        <translation>Die Brailletabelle %1 wurde nicht gefunden; Namen können nicht in Punktschrift geschrieben werden. Installieren Sie das Paket liblouis-data.</translation>
    </message>
    <message>
        <source>The bundle &quot;%1&quot; cannot be used: %2</source>
        <translation>Das Paket „%1“ kann nicht verwendet werden: %2</translation>
    </message>
    <message>
        <source>The bundle &quot;%1&quot; was not written: %2</source>
        <translation>Das Paket „%1“ wurde nicht geschrieben: %2</translation>
    </message>
    <message>
        <source>The bundle cannot be unpacked, because &quot;%1&quot; is not empty.</source>
        <translation>Das Paket kann nicht ausgepackt werden, weil „%1“ nicht leer ist.</translation>
    </message>
    <message>
        <source>The bundle cannot be unpacked: %1</source>
        <translation>Das Paket kann nicht ausgepackt werden: %1</translation>
    </message>
    <message>
        <source>The calibration misses its marks by %1 mm, more than the %2 mm allowed; touch them again.</source>
        <translation>Die Kalibrierung verfehlt ihre Marken um %1 mm, mehr als die erlaubten %2 mm; berühren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>The conflict copy &quot;%1&quot; could not be moved to the trash: %2</source>
        <translation>Die Konfliktkopie „%1“ konnte nicht in den Papierkorb verschoben werden: %2</translation>
    </message>
    <message>
        <source>The date &quot;%1&quot; is in no calendar and is left out.</source>
        <translation>Das Datum „%1“ steht in keinem Kalender und wird ausgelassen.</translation>
    </message>
    <message>
        <source>The description</source>
        <translation>Die Beschreibung</translation>
    </message>
    <message>
        <source>The device was switched off, because it no longer answers. Check its cable and start it again.</source>
        <translation>Das Gerät wurde abgeschaltet, weil es nicht mehr antwortet. Prüfen Sie sein Kabel und starten Sie es wieder.</translation>
    </message>
    <message>
        <source>The device was switched off, because this computer stopped responding for a while. Start it again when you are ready.</source>
        <translation>Das Gerät wurde abgeschaltet, weil dieser Computer eine Zeit lang nicht reagierte. Starten Sie es wieder, wenn Sie bereit sind.</translation>
    </message>
    <message>
        <source>The device with a force pad&apos;s ids does not answer like a force pad. Unplug it and plug it in again; if it is not a force pad, choose another device.</source>
        <translation>Das Gerät mit der Kennung eines Kraftpads antwortet nicht wie ein Kraftpad. Ziehen Sie es ab und schließen Sie es wieder an; ist es kein Kraftpad, wählen Sie ein anderes Gerät.</translation>
    </message>
    <message>
        <source>The drawing cannot be saved as &quot;%1&quot;: %2</source>
        <translation>Die Zeichnung kann nicht als „%1“ gespeichert werden: %2</translation>
    </message>
    <message>
        <source>The drawing cannot be saved: it needs a width and a height larger than zero.</source>
        <translation>Die Zeichnung kann nicht gespeichert werden: Sie braucht eine Breite und eine Höhe über null.</translation>
    </message>
    <message>
        <source>The drawing cannot be saved: there is not enough memory for it.</source>
        <translation>Die Zeichnung kann nicht gespeichert werden: Der Arbeitsspeicher reicht nicht.</translation>
    </message>
    <message>
        <source>The drawing could not be read: there is not enough memory for it.</source>
        <translation>Die Zeichnung konnte nicht gelesen werden: Der Arbeitsspeicher reicht nicht.</translation>
    </message>
    <message>
        <source>The drawing does not say how large it is; give it a width and a height, or a viewBox.</source>
        <translation>Die Zeichnung sagt nicht, wie groß sie ist; geben Sie ihr Breite und Höhe oder eine viewBox.</translation>
    </message>
    <message>
        <source>The drawing has more elements than a sheet of contours may have.</source>
        <translation>Die Zeichnung hat mehr Elemente, als ein Blatt mit Konturen haben darf.</translation>
    </message>
    <message>
        <source>The drawing has more lines than a sheet of contours may have.</source>
        <translation>Die Zeichnung hat mehr Linien, als ein Blatt mit Konturen haben darf.</translation>
    </message>
    <message>
        <source>The drawing is larger than 64 MB; that is more than a sheet of contours may be.</source>
        <translation>Die Zeichnung ist größer als 64 MB; das ist mehr, als ein Blatt mit Konturen haben darf.</translation>
    </message>
    <message>
        <source>The drawing&apos;s %1 &quot;%2&quot; is not a length in mm, cm, in, pt, pc or px.</source>
        <translation>%1 der Zeichnung ist „%2“; das ist keine Länge in mm, cm, in, pt, pc oder px.</translation>
    </message>
    <message>
        <source>The drawing&apos;s %1 is %2, but it must be larger than zero.</source>
        <translation>%1 der Zeichnung ist %2, muss aber größer als null sein.</translation>
    </message>
    <message>
        <source>The drawing&apos;s size is beyond what can be computed with.</source>
        <translation>Die Größe der Zeichnung ist jenseits dessen, womit gerechnet werden kann.</translation>
    </message>
    <message>
        <source>The drawing&apos;s viewBox &quot;%1&quot; is not four numbers with a width and a height larger than zero.</source>
        <translation>Die viewBox „%1“ der Zeichnung besteht nicht aus vier Zahlen mit Breite und Höhe über null.</translation>
    </message>
    <message>
        <source>The edge of the %1 is faint, so its contour may be wrong.</source>
        <translation>Der Rand %1 ist undeutlich, die Kontur könnte deshalb falsch sein.</translation>
    </message>
    <message>
        <source>The face is %1, so the contour of the %2 may be wrong.</source>
        <translation>Das Gesicht ist %1, die Kontur %2 könnte deshalb falsch sein.</translation>
    </message>
    <message>
        <source>The face is cut off at the %1 of the picture.</source>
        <translation>Das Gesicht ist am %1 des Bildes abgeschnitten.</translation>
    </message>
    <message>
        <source>The face is only %1 pixels wide, too small for its contours to be exact.</source>
        <translation>Das Gesicht ist nur %1 Pixel breit, zu klein für genaue Konturen.</translation>
    </message>
    <message>
        <source>The face of &quot;%1&quot; lies outside the photograph.</source>
        <translation>Das Gesicht von „%1“ liegt außerhalb des Fotos.</translation>
    </message>
    <message>
        <source>The faces were marked on a picture of another shape, so their places may be wrong.</source>
        <translation>Die Gesichter wurden auf einem Bild mit anderen Seitenlängen markiert, ihre Stellen könnten deshalb falsch sein.</translation>
    </message>
    <message>
        <source>The file &quot;%1&quot; cannot be opened; you may not be allowed to read it.</source>
        <translation>Die Datei „%1“ kann nicht geöffnet werden; vielleicht dürfen Sie sie nicht lesen.</translation>
    </message>
    <message>
        <source>The file &quot;%1&quot; cannot be read to its end.</source>
        <translation>Die Datei „%1“ kann nicht bis zu ihrem Ende gelesen werden.</translation>
    </message>
    <message>
        <source>The file &quot;%1&quot; cannot be read.</source>
        <translation>Die Datei „%1“ kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The file &quot;%1&quot; could not be read: there is not enough memory for it.</source>
        <translation>Die Datei „%1“ konnte nicht gelesen werden: Der Arbeitsspeicher reicht nicht.</translation>
    </message>
    <message>
        <source>The file &quot;%1&quot; is named like a photograph, but is not one.</source>
        <translation>Die Datei „%1“ heißt wie ein Foto, ist aber keines.</translation>
    </message>
    <message>
        <source>The file &quot;%1&quot; is in a folder that you are not allowed to open.</source>
        <translation>Die Datei „%1“ ist in einem Ordner, den Sie nicht öffnen dürfen.</translation>
    </message>
    <message>
        <source>The file &quot;%1&quot; is larger than %2 MB; that is more than such a file may be.</source>
        <translation>Die Datei „%1“ ist größer als %2 MB; das ist mehr, als so eine Datei haben darf.</translation>
    </message>
    <message>
        <source>The file cannot be read.</source>
        <translation>Die Datei kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>Die Datei ist leer.</translation>
    </message>
    <message>
        <source>The file is not a picture of a kind that can be read.</source>
        <translation>Die Datei ist kein Bild einer Art, die gelesen werden kann.</translation>
    </message>
    <message>
        <source>The file is too large to be a photograph: more than 2 gigabytes.</source>
        <translation>Die Datei ist zu groß für ein Foto: mehr als 2 Gigabyte.</translation>
    </message>
    <message>
        <source>The fingerprint of the photograph</source>
        <translation>Der Fingerabdruck des Fotos</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be created: %2</source>
        <translation>Der Ordner „%1“ kann nicht angelegt werden: %2</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be read: %2</source>
        <translation>Der Ordner „%1“ kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; is missing.</source>
        <translation>Der Ordner „%1“ fehlt.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; leads to the whole computer; it is left alone.</source>
        <translation>Der Ordner „%1“ führt zum ganzen Computer und bleibt unangetastet.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be opened: you are not allowed to.</source>
        <translation>Sie dürfen den Ordner „%1“ nicht öffnen.</translation>
    </message>
    <message>
        <source>The force is off for a moment, because this computer was too busy to guide the finger.</source>
        <translation>Die Kraft ist kurz aus, weil dieser Computer zu beschäftigt war, um den Finger zu führen.</translation>
    </message>
    <message>
        <source>The force is off, because the device does not say where the finger is.</source>
        <translation>Die Kraft ist aus, weil das Gerät nicht sagt, wo der Finger ist.</translation>
    </message>
    <message>
        <source>The force is off, because the device has switched its motors off to be safe. It comes back when the device is ready.</source>
        <translation>Die Kraft ist aus, weil das Gerät seine Motoren zur Sicherheit abgeschaltet hat. Sie kommt zurück, wenn das Gerät bereit ist.</translation>
    </message>
    <message>
        <source>The force is off, because the finger is outside the area that the device reaches. Move it back.</source>
        <translation>Die Kraft ist aus, weil der Finger außerhalb des Bereichs ist, den das Gerät erreicht. Bewegen Sie ihn zurück.</translation>
    </message>
    <message>
        <source>The force is off, because the finger moves too fast. Move slowly and it comes back.</source>
        <translation>Die Kraft ist aus, weil der Finger sich zu schnell bewegt. Bewegen Sie ihn langsam, dann kommt sie zurück.</translation>
    </message>
    <message>
        <source>The force pad %1 reports values that cannot be right: %2. It needs different firmware.</source>
        <translation>Das Kraftpad %1 meldet Werte, die nicht stimmen können: %2. Es braucht eine andere Firmware.</translation>
    </message>
    <message>
        <source>The force pad could not be homed. Check that it is plugged in, and try again.</source>
        <translation>Der Nullpunkt des Kraftpads konnte nicht gesetzt werden. Prüfen Sie, ob es angeschlossen ist, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The force pad did not say which places it reaches. Unplug it and plug it in again.</source>
        <translation>Das Kraftpad hat nicht gesagt, welche Stellen es erreicht. Ziehen Sie es ab und schließen Sie es wieder an.</translation>
    </message>
    <message>
        <source>The force pad does not know where its knob is. Put the knob on its mark and home the pad.</source>
        <translation>Das Kraftpad weiß nicht, wo sein Knopf ist. Setzen Sie den Knopf auf seine Marke, und setzen Sie dann den Nullpunkt des Geräts.</translation>
    </message>
    <message>
        <source>The force pad heard nothing from this computer for a moment and switched its motors off.</source>
        <translation>Das Kraftpad hörte einen Moment lang nichts von diesem Computer und schaltete seine Motoren ab.</translation>
    </message>
    <message>
        <source>The force pad&apos;s encoders contradict each other: a cable is slack, or one has slipped. Put the knob on its mark and home the pad.</source>
        <translation>Die Geber des Kraftpads widersprechen sich: Ein Seil ist schlaff, oder einer ist verrutscht. Setzen Sie den Knopf auf seine Marke, und setzen Sie dann den Nullpunkt des Geräts.</translation>
    </message>
    <message>
        <source>The force pad&apos;s motors are off.</source>
        <translation>Die Motoren des Kraftpads sind aus.</translation>
    </message>
    <message>
        <source>The force pad&apos;s motors are too hot. It goes on by itself when they have cooled.</source>
        <translation>Die Motoren des Kraftpads sind zu heiß. Es geht von selbst weiter, wenn sie abgekühlt sind.</translation>
    </message>
    <message>
        <source>The force was switched off for a moment, because a measurement was not a number.</source>
        <translation>Die Kraft wurde kurz abgeschaltet, weil ein Messwert keine Zahl war.</translation>
    </message>
    <message>
        <source>The import cannot begin: %1</source>
        <translation>Der Import kann nicht beginnen: %1</translation>
    </message>
    <message>
        <source>The import ended, because the computer reports: %1</source>
        <translation>Der Import endete, weil der Computer meldet: %1</translation>
    </message>
    <message>
        <source>The import&apos;s list cannot be removed: %1</source>
        <translation>Die Liste des Imports kann nicht entfernt werden: %1</translation>
    </message>
    <message>
        <source>The kind %1</source>
        <translation>Die Art %1</translation>
    </message>
    <message>
        <source>The language %1</source>
        <translation>Die Sprache %1</translation>
    </message>
    <message>
        <source>The list of the import &quot;%1&quot; cannot be read; import its folder again, nothing comes twice.</source>
        <translation>Die Liste des Imports „%1“ kann nicht gelesen werden; importieren Sie den Ordner noch einmal, nichts kommt doppelt.</translation>
    </message>
    <message>
        <source>The list of what was deleted in &quot;%1&quot; cannot be read; its files are still there.</source>
        <translation>Die Liste des Gelöschten in „%1“ kann nicht gelesen werden; die Dateien sind noch da.</translation>
    </message>
    <message>
        <source>The map between two frames cannot be inverted, because it flattens the plane to a line.</source>
        <translation>Die Abbildung zwischen zwei Flächen kann nicht umgekehrt werden, weil sie die Ebene zu einer Linie plattdrückt.</translation>
    </message>
    <message>
        <source>The mended contours &quot;%1&quot; cannot be removed: %2</source>
        <translation>Die korrigierten Konturen „%1“ können nicht entfernt werden: %2</translation>
    </message>
    <message>
        <source>The mended contours cannot be saved as &quot;%1&quot;: %2</source>
        <translation>Die korrigierten Konturen können nicht als „%1“ gespeichert werden: %2</translation>
    </message>
    <message>
        <source>The mended contours in %1 cannot be used, so the program&apos;s own are used: %2</source>
        <translation>Die korrigierten Konturen in %1 können nicht verwendet werden, es gelten die des Programms: %2</translation>
    </message>
    <message>
        <source>The mended contours in %1 cannot be used: %2</source>
        <translation>Die korrigierten Konturen in %1 können nicht verwendet werden: %2</translation>
    </message>
    <message>
        <source>The name cannot be saved: %1</source>
        <translation>Der Name kann nicht gespeichert werden: %1</translation>
    </message>
    <message>
        <source>The name of a face</source>
        <translation>Der Name eines Gesichts</translation>
    </message>
    <message>
        <source>The nets that find faces cannot be used: %1</source>
        <translation>Die Netze, die Gesichter finden, können nicht benutzt werden: %1</translation>
    </message>
    <message>
        <source>The person %1</source>
        <translation>Die Person %1</translation>
    </message>
    <message>
        <source>The photograph &quot;%1&quot; cannot be read: %2</source>
        <translation>Das Foto „%1“ kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>The photograph &quot;%1&quot; cannot be read: you are not allowed to.</source>
        <translation>Das Foto „%1“ kann nicht gelesen werden: Sie dürfen es nicht.</translation>
    </message>
    <message>
        <source>The photograph &quot;%1&quot; is now &quot;%2&quot;, but what belongs to it stayed behind: %3</source>
        <translation>Das Foto „%1“ heißt jetzt „%2“, aber was dazugehört, blieb zurück: %3</translation>
    </message>
    <message>
        <source>The photograph &quot;%1&quot; holds more metadata than any program writes; it was not read.</source>
        <translation>Das Foto „%1“ enthält mehr Metadaten, als ein Programm schreibt; es wurde nicht gelesen.</translation>
    </message>
    <message>
        <source>The photograph&apos;s EXIF is damaged.</source>
        <translation>Die EXIF-Daten des Fotos sind beschädigt.</translation>
    </message>
    <message>
        <source>The photograph&apos;s IPTC is damaged.</source>
        <translation>Die IPTC-Daten des Fotos sind beschädigt.</translation>
    </message>
    <message>
        <source>The photograph&apos;s XMP cannot be read: %1</source>
        <translation>Die XMP-Daten des Fotos können nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>The photograph&apos;s XMP is damaged.</source>
        <translation>Die XMP-Daten des Fotos sind beschädigt.</translation>
    </message>
    <message>
        <source>The photograph&apos;s own metadata is damaged; what could be read of it is used.</source>
        <translation>Die Metadaten des Fotos sind beschädigt; verwendet wird, was davon gelesen werden konnte.</translation>
    </message>
    <message>
        <source>The picture cannot be decoded.</source>
        <translation>Das Bild kann nicht decodiert werden.</translation>
    </message>
    <message>
        <source>The picture is empty.</source>
        <translation>Das Bild ist leer.</translation>
    </message>
    <message>
        <source>The picture is not in 8-bit colour.</source>
        <translation>Das Bild hat keine 8-Bit-Farben.</translation>
    </message>
    <message>
        <source>The picture is only %1 × %2 pixels, too small to show a face.</source>
        <translation>Das Bild hat nur %1 × %2 Pixel, zu wenig, um ein Gesicht zu zeigen.</translation>
    </message>
    <message>
        <source>The picture is too large: %1 × %2 pixels, where at most %3 million can be read.</source>
        <translation>Das Bild ist zu groß: %1 × %2 Pixel, höchstens %3 Millionen können gelesen werden.</translation>
    </message>
    <message>
        <source>The picture or the touch surface is too large or too small to be computed with.</source>
        <translation>Das Bild oder die Tastfläche ist zu groß oder zu klein, um damit zu rechnen.</translation>
    </message>
    <message>
        <source>The place of %1 makes no sense and is left out.</source>
        <translation>Die Stelle für %1 ergibt keinen Sinn und wird ausgelassen.</translation>
    </message>
    <message>
        <source>The place of the face must lie in the picture, 0 to 1 from its left and upper edge.</source>
        <translation>Die Stelle des Gesichts muss im Bild liegen, 0 bis 1 vom linken und oberen Rand.</translation>
    </message>
    <message>
        <source>The position is not a place on Earth and is left out.</source>
        <translation>Die Position ist kein Ort auf der Erde und wird ausgelassen.</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot;</source>
        <translation>Die Aufnahme „%1“</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; can only be played from its beginning.</source>
        <translation>Die Aufnahme „%1“ kann nur von ihrem Anfang an abgespielt werden.</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; cannot be listed twice.</source>
        <translation>Die Aufnahme „%1“ kann nicht zweimal aufgeführt werden.</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; cannot be listed: XML cannot hold such a file name.</source>
        <translation>Die Aufnahme „%1“ kann nicht aufgeführt werden: XML kann so einen Dateinamen nicht fassen.</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; cannot be played: %2</source>
        <translation>Die Aufnahme „%1“ kann nicht abgespielt werden: %2</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; cannot be used: %2</source>
        <translation>Die Aufnahme „%1“ kann nicht verwendet werden: %2</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; is kept, but the photograph&apos;s list could not be written: %2</source>
        <translation>Die Aufnahme „%1“ ist aufbewahrt, aber die Liste des Fotos konnte nicht geschrieben werden: %2</translation>
    </message>
    <message>
        <source>The recording %1 could not be written. Choose a folder that you may write to.</source>
        <translation>Die Aufzeichnung %1 konnte nicht geschrieben werden. Wählen Sie einen Ordner, in den Sie schreiben dürfen.</translation>
    </message>
    <message>
        <source>The recording %1 is listed twice; the first is used.</source>
        <translation>Die Aufnahme %1 ist zweimal aufgeführt; die erste gilt.</translation>
    </message>
    <message>
        <source>The replay was stopped.</source>
        <translation>Die Wiedergabe wurde angehalten.</translation>
    </message>
    <message>
        <source>The scene has no line that can be felt.</source>
        <translation>Die Szene hat keine Linie, die man fühlen kann.</translation>
    </message>
    <message>
        <source>The search for faces failed (%1).</source>
        <translation>Die Suche nach Gesichtern schlug fehl (%1).</translation>
    </message>
    <message>
        <source>The search for faces was stopped.</source>
        <translation>Die Suche nach Gesichtern wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The short description</source>
        <translation>Die kurze Beschreibung</translation>
    </message>
    <message>
        <source>The sidecar &quot;%1&quot; cannot be read: %2</source>
        <translation>Die Begleitdatei „%1“ kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>The sidecar &quot;%1&quot; could not be written: %2</source>
        <translation>Die Begleitdatei „%1“ konnte nicht geschrieben werden: %2</translation>
    </message>
    <message>
        <source>The sidecar of &quot;%1&quot; could not be written: another program is busy there.</source>
        <translation>Die Begleitdatei von „%1“ konnte nicht geschrieben werden: Ein anderes Programm arbeitet gerade daran.</translation>
    </message>
    <message>
        <source>The sidecar of &quot;%1&quot; was changed in two places at once; it holds both now, and the copy &quot;%2&quot; is in the trash.</source>
        <translation>Die Begleitdatei von „%1“ wurde an zwei Orten zugleich geändert; sie enthält jetzt beides, und die Kopie „%2“ ist im Papierkorb.</translation>
    </message>
    <message>
        <source>The sound of &quot;%1&quot; is not whole. %2</source>
        <translation>Der Ton von „%1“ ist nicht vollständig. %2</translation>
    </message>
    <message>
        <source>The sound of the video &quot;%1&quot; is not imported: %2</source>
        <translation>Der Ton des Videos „%1“ wird nicht importiert: %2</translation>
    </message>
    <message>
        <source>The sound of the video in &quot;%1&quot; is not imported: %2</source>
        <translation>Der Ton des Videos in „%1“ wird nicht importiert: %2</translation>
    </message>
    <message>
        <source>The speaker %1</source>
        <translation>Wer spricht, bei: %1</translation>
    </message>
    <message>
        <source>The system gives this program no thread to work on; close other programs.</source>
        <translation>Das System stellt diesem Programm keinen Thread bereit; schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>The system watches only a part of the album&apos;s folders; changes by other programs in the others are noticed %1 seconds later.</source>
        <translation>Das System beobachtet nur einen Teil der Ordner des Albums; was andere Programme in den übrigen ändern, wird %1 Sekunden später bemerkt.</translation>
    </message>
    <message>
        <source>The tactile sheet cannot be saved as &quot;%1&quot;: %2</source>
        <translation>Das Tastblatt kann nicht als „%1“ gespeichert werden: %2</translation>
    </message>
    <message>
        <source>The time %1</source>
        <translation>Die Zeit %1</translation>
    </message>
    <message>
        <source>The transcript %1</source>
        <translation>Die Abschrift %1</translation>
    </message>
    <message>
        <source>The trash could not be emptied: %1</source>
        <translation>Der Papierkorb konnte nicht geleert werden: %1</translation>
    </message>
    <message>
        <source>The widths of hysteresis and blending are from 0 to 5 mm.</source>
        <translation>Die Breiten von Hysterese und Überblendung liegen zwischen 0 und 5 mm.</translation>
    </message>
    <message>
        <source>There is a file %1 already. Choose another name for the recording.</source>
        <translation>Es gibt schon eine Datei %1. Wählen Sie einen anderen Namen für die Aufzeichnung.</translation>
    </message>
    <message>
        <source>There is no braille for the language &quot;%1&quot;; there is for en, de and ko.</source>
        <translation>Für die Sprache „%1“ gibt es keine Punktschrift; es gibt sie für en, de und ko.</translation>
    </message>
    <message>
        <source>There is no device &quot;%1&quot; now. Check that it is plugged in; &quot;touchphoto-lab devices&quot; lists what is there.</source>
        <translation>Das Gerät „%1“ gibt es jetzt nicht. Prüfen Sie, ob es angeschlossen ist; „touchphoto-lab devices“ zählt auf, was da ist.</translation>
    </message>
    <message>
        <source>There is no face %1 in this picture; it has %2.</source>
        <translation>In diesem Bild gibt es kein Gesicht %1; so viele hat es: %2.</translation>
    </message>
    <message>
        <source>There is no file &quot;%1&quot;.</source>
        <translation>Es gibt keine Datei „%1“.</translation>
    </message>
    <message>
        <source>There is no file or folder &quot;%1&quot;.</source>
        <translation>Es gibt weder Datei noch Ordner „%1“.</translation>
    </message>
    <message>
        <source>There is no line to draw on these faces.</source>
        <translation>Auf diesen Gesichtern gibt es keine Linie zu zeichnen.</translation>
    </message>
    <message>
        <source>There is no photograph &quot;%1&quot;.</source>
        <translation>Es gibt kein Foto „%1“.</translation>
    </message>
    <message>
        <source>There is no photograph to export.</source>
        <translation>Es gibt kein Foto zum Exportieren.</translation>
    </message>
    <message>
        <source>There is no recording &quot;%1&quot; on &quot;%2&quot;.</source>
        <translation>Es gibt keine Aufnahme „%1“ bei „%2“.</translation>
    </message>
    <message>
        <source>There is no such file.</source>
        <translation>Diese Datei gibt es nicht.</translation>
    </message>
    <message>
        <source>There is no unfinished import &quot;%1&quot;.</source>
        <translation>Es gibt keinen unfertigen Import „%1“.</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture.</source>
        <translation>Für dieses Bild reicht der Arbeitsspeicher nicht.</translation>
    </message>
    <message>
        <source>There is nothing of the name &quot;%1&quot; in the trash.</source>
        <translation>Im Papierkorb gibt es nichts mit dem Namen „%1“.</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>Es gibt nichts zu wiederholen.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Es gibt nichts rückgängig zu machen.</translation>
    </message>
    <message>
        <source>This could not be done, because the computer reports: %1</source>
        <translation>Das ging nicht, weil der Computer meldet: %1</translation>
    </message>
    <message>
        <source>This is a compressed drawing (svgz); save it as plain SVG.</source>
        <translation>Das ist eine komprimierte Zeichnung (svgz); speichern Sie sie als einfaches SVG.</translation>
    </message>
    <message>
        <source>This is a folder, not a picture.</source>
        <translation>Das ist ein Ordner, kein Bild.</translation>
    </message>
    <message>
        <source>This is not a recording of a force device, or it is from a later version of TouchPhoto.</source>
        <translation>Das ist keine Aufzeichnung eines Kraftgeräts, oder sie stammt von einer späteren Version von TouchPhoto.</translation>
    </message>
    <message>
        <source>This is not an SVG drawing: it begins with &lt;%1&gt; where &lt;svg&gt; is expected.</source>
        <translation>Das ist keine SVG-Zeichnung: Sie beginnt mit &lt;%1&gt;, wo &lt;svg&gt; erwartet wird.</translation>
    </message>
    <message>
        <source>This is not an SVG drawing: its text is broken near line %1.</source>
        <translation>Das ist keine SVG-Zeichnung: Ihr Text ist nahe Zeile %1 fehlerhaft.</translation>
    </message>
    <message>
        <source>This is not an SVG drawing: there is nothing in it.</source>
        <translation>Das ist keine SVG-Zeichnung: Es ist nichts darin.</translation>
    </message>
    <message>
        <source>This part of the face was not found in the picture.</source>
        <translation>Dieser Teil des Gesichts wurde im Bild nicht gefunden.</translation>
    </message>
    <message>
        <source>This picture could not be read. It may be too large for this computer.</source>
        <translation>Dieses Bild konnte nicht gelesen werden. Vielleicht ist es für diesen Computer zu groß.</translation>
    </message>
    <message>
        <source>This picture could not be worked on. It may be too large for this computer.</source>
        <translation>Dieses Bild konnte nicht bearbeitet werden. Vielleicht ist es für diesen Computer zu groß.</translation>
    </message>
    <message>
        <source>What another program wrote cannot be saved: %1</source>
        <translation>Was ein anderes Programm geschrieben hat, kann nicht gespeichert werden: %1</translation>
    </message>
    <message>
        <source>What other programs wrote differs in: %1. The other version is in the copy.</source>
        <translation>Was andere Programme geschrieben haben, unterscheidet sich in: %1. Die andere Fassung ist in der Kopie.</translation>
    </message>
    <message>
        <source>The metadata of the photograph &quot;%1&quot; cannot be read.</source>
        <translation>Die Metadaten des Fotos „%1“ können nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Windows does not let this program use the %1. Unplug it and plug it in again; if that does not help, close other programs that use it.</source>
        <translation>Windows lässt dieses Programm das Gerät nicht benutzen: %1. Ziehen Sie es ab und schließen Sie es wieder an; hilft das nicht, schließen Sie andere Programme, die es benutzen.</translation>
    </message>
    <message>
        <source>You are not allowed to read the photograph &quot;%1&quot;.</source>
        <translation>Sie dürfen das Foto „%1“ nicht lesen.</translation>
    </message>
    <message>
        <source>You are not allowed to use the %1 yet. Copy resources/udev/70-touchphoto.rules to /etc/udev/rules.d, then unplug the device and plug it in again.</source>
        <translation>Sie dürfen dieses Gerät noch nicht benutzen: %1. Kopieren Sie resources/udev/70-touchphoto.rules nach /etc/udev/rules.d, ziehen Sie dann das Gerät ab und schließen Sie es wieder an.</translation>
    </message>
    <message>
        <source>a face</source>
        <translation>ein Gesicht</translation>
    </message>
    <message>
        <source>a face lost its name</source>
        <translation>ein Gesicht verlor seinen Namen</translation>
    </message>
    <message>
        <source>a face was named %1</source>
        <translation>ein Gesicht bekam den Namen %1</translation>
    </message>
    <message>
        <source>a place of its scene is not two numbers in millimetres.</source>
        <translation>Eine Stelle der Szene besteht nicht aus zwei Zahlen in Millimetern.</translation>
    </message>
    <message>
        <source>a recording is at most %1 hours long.</source>
        <translation>Eine Aufnahme ist höchstens %1 Stunden lang.</translation>
    </message>
    <message>
        <source>a recording is mono or stereo, with 8000 to 192000 samples a second.</source>
        <translation>Eine Aufnahme ist mono oder stereo, mit 8000 bis 192000 Abtastwerten in der Sekunde.</translation>
    </message>
    <message>
        <source>another program is using it.</source>
        <translation>Ein anderes Programm benutzt sie.</translation>
    </message>
    <message>
        <source>another program is writing to it.</source>
        <translation>Ein anderes Programm schreibt gerade daran.</translation>
    </message>
    <message>
        <source>another program is writing to it. %1</source>
        <translation>Ein anderes Programm schreibt gerade daran. %1</translation>
    </message>
    <message>
        <source>another program keeps writing to it.</source>
        <translation>Ein anderes Programm schreibt immer wieder daran.</translation>
    </message>
    <message>
        <source>bottom edge</source>
        <translation>unteren Rand</translation>
    </message>
    <message>
        <source>files that an earlier program left behind are in the way.</source>
        <translation>Dateien, die ein früheres Programm hinterließ, sind im Weg.</translation>
    </message>
    <message>
        <source>force pad</source>
        <translation>Kraftpad</translation>
    </message>
    <message>
        <source>force pad with a pantograph</source>
        <translation>Kraftpad mit Pantograf</translation>
    </message>
    <message>
        <source>force pad with cables</source>
        <translation>Kraftpad mit Seilen</translation>
    </message>
    <message>
        <source>how somebody says %1</source>
        <translation>wie jemand %1 ausspricht</translation>
    </message>
    <message>
        <source>is damaged</source>
        <translation>ist beschädigt</translation>
    </message>
    <message>
        <source>it acts more than 50 milliseconds late</source>
        <translation>Es wirkt mehr als 50 Millisekunden zu spät</translation>
    </message>
    <message>
        <source>it cannot be read to its end.</source>
        <translation>Die Datei kann nicht bis zu ihrem Ende gelesen werden.</translation>
    </message>
    <message>
        <source>it cannot be read: %1</source>
        <translation>Die Datei kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>it cannot be set aside.</source>
        <translation>Die Datei kann nicht beiseitegelegt werden.</translation>
    </message>
    <message>
        <source>it cannot be written.</source>
        <translation>Es kann nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>it does not begin like a WAV file.</source>
        <translation>Die Datei beginnt nicht wie eine WAV-Datei.</translation>
    </message>
    <message>
        <source>it has %1 channels; at most %2 can be read.</source>
        <translation>Die Datei hat %1 Kanäle; höchstens %2 können gelesen werden.</translation>
    </message>
    <message>
        <source>it has another name too, and is not written into.</source>
        <translation>Die Datei hat noch einen anderen Namen; in sie wird nicht geschrieben.</translation>
    </message>
    <message>
        <source>it has more entries than any program writes.</source>
        <translation>Die Datei hat mehr Einträge, als ein Programm schreibt.</translation>
    </message>
    <message>
        <source>it has no samples.</source>
        <translation>Die Datei hat keine Abtastwerte.</translation>
    </message>
    <message>
        <source>it has no sound.</source>
        <translation>Es ist kein Ton darin.</translation>
    </message>
    <message>
        <source>it holds &quot;%1&quot;, which is not a plain file.</source>
        <translation>Es enthält „%1“, das keine gewöhnliche Datei ist.</translation>
    </message>
    <message>
        <source>it holds &quot;%1&quot;, which would lie outside the album.</source>
        <translation>Es enthält „%1“, das außerhalb des Albums liegen würde.</translation>
    </message>
    <message>
        <source>it holds a file in more folders than any album has.</source>
        <translation>Es enthält eine Datei in mehr Ordnern, als ein Album hat.</translation>
    </message>
    <message>
        <source>it holds a file without a name.</source>
        <translation>Es enthält eine Datei ohne Namen.</translation>
    </message>
    <message>
        <source>it holds more files than any album.</source>
        <translation>Es enthält mehr Dateien als ein Album.</translation>
    </message>
    <message>
        <source>it holds no sound.</source>
        <translation>Es ist kein Ton darin.</translation>
    </message>
    <message>
        <source>it is a link; it is left alone.</source>
        <translation>Das ist eine Verknüpfung; sie bleibt unangetastet.</translation>
    </message>
    <message>
        <source>it is damaged there.</source>
        <translation>Dort ist es beschädigt.</translation>
    </message>
    <message>
        <source>it is damaged, and cannot be read to its end.</source>
        <translation>Die Datei ist beschädigt und kann nicht bis zu ihrem Ende gelesen werden.</translation>
    </message>
    <message>
        <source>it is damaged, or not a sound file that can be read here.</source>
        <translation>Die Datei ist beschädigt, oder keine Tondatei, die hier gelesen werden kann.</translation>
    </message>
    <message>
        <source>it is damaged, or not a video that can be read here.</source>
        <translation>Die Datei ist beschädigt, oder kein Video, das hier gelesen werden kann.</translation>
    </message>
    <message>
        <source>it is damaged.</source>
        <translation>Die Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>it is empty.</source>
        <translation>Die Datei ist leer.</translation>
    </message>
    <message>
        <source>it is larger than %1 MB.</source>
        <translation>Die Datei ist größer als %1 MB.</translation>
    </message>
    <message>
        <source>it is locked with a password.</source>
        <translation>Es ist mit einem Passwort geschützt.</translation>
    </message>
    <message>
        <source>it is longer than %1 hours, or claims to be.</source>
        <translation>Es ist länger als %1 Stunden, oder behauptet es.</translation>
    </message>
    <message>
        <source>it is longer than %1 hours.</source>
        <translation>Es ist länger als %1 Stunden.</translation>
    </message>
    <message>
        <source>it is longer than a minute, so it is a film and not the photograph&apos;s.</source>
        <translation>Es ist länger als eine Minute, also ein Film und nicht der Ton des Fotos.</translation>
    </message>
    <message>
        <source>it is neither mono nor stereo.</source>
        <translation>Die Datei ist weder mono noch stereo.</translation>
    </message>
    <message>
        <source>it is nested more deeply than any program writes.</source>
        <translation>Die Datei ist tiefer verschachtelt, als ein Programm schreibt.</translation>
    </message>
    <message>
        <source>it is not a lab setup of version 1.</source>
        <translation>Das ist keine Laboreinstellung der Version 1.</translation>
    </message>
    <message>
        <source>it is not a sound file that can be read here.</source>
        <translation>Das ist keine Tondatei, die hier gelesen werden kann.</translation>
    </message>
    <message>
        <source>it is not XMP.</source>
        <translation>Das ist kein XMP.</translation>
    </message>
    <message>
        <source>it is not a FLAC file.</source>
        <translation>Das ist keine FLAC-Datei.</translation>
    </message>
    <message>
        <source>it is not a bundle, or it is damaged.</source>
        <translation>Das ist kein Paket, oder es ist beschädigt.</translation>
    </message>
    <message>
        <source>it is not a file.</source>
        <translation>Das ist keine Datei.</translation>
    </message>
    <message>
        <source>it does not exist.</source>
        <translation>Die Datei gibt es nicht.</translation>
    </message>
    <message>
        <source>it is not whole XML.</source>
        <translation>Das ist kein vollständiges XML.</translation>
    </message>
    <message>
        <source>it names a law that is unknown.</source>
        <translation>Ein unbekanntes Führungsgesetz ist genannt.</translation>
    </message>
    <message>
        <source>it reaches farther than two metres</source>
        <translation>Es reicht weiter als zwei Meter</translation>
    </message>
    <message>
        <source>it reaches less than a square centimetre</source>
        <translation>Es erreicht weniger als einen Quadratzentimeter</translation>
    </message>
    <message>
        <source>it was stopped.</source>
        <translation>Der Vorgang wurde angehalten.</translation>
    </message>
    <message>
        <source>it would become larger than any program reads.</source>
        <translation>Die Datei würde größer, als ein Programm liest.</translation>
    </message>
    <message>
        <source>it would become too large (&quot;%1&quot;).</source>
        <translation>Es würde zu groß („%1“).</translation>
    </message>
    <message>
        <source>its comments are damaged.</source>
        <translation>Die Kommentare der Datei sind beschädigt.</translation>
    </message>
    <message>
        <source>its edge is faint</source>
        <translation>der Rand ist undeutlich</translation>
    </message>
    <message>
        <source>its folder is gone.</source>
        <translation>Der Ordner ist nicht mehr da.</translation>
    </message>
    <message>
        <source>its head is damaged.</source>
        <translation>Der Kopf der Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>its header is damaged.</source>
        <translation>Der Kopf der Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>its strongest force is zero or above 20 newtons</source>
        <translation>Seine maximale Kraft ist null oder über 20 Newton</translation>
    </message>
    <message>
        <source>its letters are in an encoding that XMP does not allow.</source>
        <translation>Der Text hat eine Kodierung, die XMP nicht erlaubt.</translation>
    </message>
    <message>
        <source>its name is too long.</source>
        <translation>Der Name ist zu lang.</translation>
    </message>
    <message>
        <source>its rate is below 50 or above 8000 hertz</source>
        <translation>Sein Takt liegt unter 50 oder über 8000 Hertz</translation>
    </message>
    <message>
        <source>recordings do not have its sample rate.</source>
        <translation>Aufnahmen haben keine solche Abtastrate.</translation>
    </message>
    <message>
        <source>its samples are not of 16 bit.</source>
        <translation>Die Abtastwerte haben nicht 16 Bit.</translation>
    </message>
    <message>
        <source>its sound cannot be decoded.</source>
        <translation>Der Ton kann nicht decodiert werden.</translation>
    </message>
    <message>
        <source>its sound has %1 channels; at most %2 can be read.</source>
        <translation>Der Ton hat %1 Kanäle; höchstens %2 können gelesen werden.</translation>
    </message>
    <message>
        <source>its sound is of a kind that cannot be decoded here (%1).</source>
        <translation>Der Ton ist von einer Art, die hier nicht decodiert werden kann (%1).</translation>
    </message>
    <message>
        <source>its texts are too long.</source>
        <translation>Die Texte sind zu lang.</translation>
    </message>
    <message>
        <source>its watchdog does not wait 20 to 50 milliseconds</source>
        <translation>Sein Wächter wartet nicht 20 bis 50 Millisekunden</translation>
    </message>
    <message>
        <source>left and bottom edges</source>
        <translation>linken und unteren Rand</translation>
    </message>
    <message>
        <source>left and right and bottom edges</source>
        <translation>linken, rechten und unteren Rand</translation>
    </message>
    <message>
        <source>left and right and top and bottom edges</source>
        <translation>linken, rechten, oberen und unteren Rand</translation>
    </message>
    <message>
        <source>left and right and top edges</source>
        <translation>linken, rechten und oberen Rand</translation>
    </message>
    <message>
        <source>left and right edges</source>
        <translation>linken und rechten Rand</translation>
    </message>
    <message>
        <source>left and top and bottom edges</source>
        <translation>linken, oberen und unteren Rand</translation>
    </message>
    <message>
        <source>left and top edges</source>
        <translation>linken und oberen Rand</translation>
    </message>
    <message>
        <source>left edge</source>
        <translation>linken Rand</translation>
    </message>
    <message>
        <source>left eye</source>
        <translation>des linken Auges</translation>
    </message>
    <message>
        <source>macOS does not let this program use the %1. Allow it under System Settings, Privacy &amp; Security, Input Monitoring, and start it again.</source>
        <translation>macOS lässt dieses Programm das Gerät nicht benutzen: %1. Erlauben Sie es unter Systemeinstellungen, Datenschutz &amp; Sicherheit, Eingabeüberwachung, und starten Sie das Programm neu.</translation>
    </message>
    <message>
        <source>may be covered</source>
        <translation>vielleicht verdeckt</translation>
    </message>
    <message>
        <source>mouth</source>
        <translation>des Mundes</translation>
    </message>
    <message>
        <source>nothing of it can be read.</source>
        <translation>Nichts davon kann gelesen werden.</translation>
    </message>
    <message>
        <source>nothing of its sound can be decoded.</source>
        <translation>Nichts von dem Ton kann decodiert werden.</translation>
    </message>
    <message>
        <source>of the recording &quot;%1&quot;</source>
        <translation>der Aufnahme „%1“</translation>
    </message>
    <message>
        <source>outline</source>
        <translation>des Gesichtsumrisses</translation>
    </message>
    <message>
        <source>reading it needs the library %1 of FFmpeg (Debian: %2), which is not installed.</source>
        <translation>Zum Lesen fehlt die Bibliothek %1 von FFmpeg (Debian: %2).</translation>
    </message>
    <message>
        <source>right and bottom edges</source>
        <translation>rechten und unteren Rand</translation>
    </message>
    <message>
        <source>right and top and bottom edges</source>
        <translation>rechten, oberen und unteren Rand</translation>
    </message>
    <message>
        <source>right and top edges</source>
        <translation>rechten und oberen Rand</translation>
    </message>
    <message>
        <source>right edge</source>
        <translation>rechten Rand</translation>
    </message>
    <message>
        <source>right eye</source>
        <translation>des rechten Auges</translation>
    </message>
    <message>
        <source>simulated device</source>
        <translation>simuliertes Gerät</translation>
    </message>
    <message>
        <source>the FLAC encoder reports a fault.</source>
        <translation>Der FLAC-Kodierer meldet einen Fehler.</translation>
    </message>
    <message>
        <source>the disk is full.</source>
        <translation>Der Datenträger ist voll.</translation>
    </message>
    <message>
        <source>the disk reports a fault.</source>
        <translation>Der Datenträger meldet einen Fehler.</translation>
    </message>
    <message>
        <source>the face of &quot;%1&quot;</source>
        <translation>das Gesicht von „%1“</translation>
    </message>
    <message>
        <source>the memo</source>
        <translation>das Memo</translation>
    </message>
    <message>
        <source>the memo about %1</source>
        <translation>das Memo über %1</translation>
    </message>
    <message>
        <source>the mouse or a finger on the screen</source>
        <translation>die Maus oder ein Finger auf dem Bildschirm</translation>
    </message>
    <message>
        <source>the name of %1 was recorded</source>
        <translation>der Name von %1 wurde aufgenommen</translation>
    </message>
    <message>
        <source>the recorded name of %1 became that of %2</source>
        <translation>der aufgenommene Name von %1 wurde zu dem von %2</translation>
    </message>
    <message>
        <source>the recordings of %1 were put in order</source>
        <translation>die Aufnahmen von %1 wurden geordnet</translation>
    </message>
    <message>
        <source>the story</source>
        <translation>die Geschichte</translation>
    </message>
    <message>
        <source>the story about %1</source>
        <translation>die Geschichte über %1</translation>
    </message>
    <message>
        <source>there are too many files of that name already.</source>
        <translation>Es gibt schon zu viele Dateien dieses Namens.</translation>
    </message>
    <message>
        <source>there are too many photographs of that name in the album.</source>
        <translation>Im Album gibt es zu viele Fotos dieses Namens.</translation>
    </message>
    <message>
        <source>there is a file of that name already.</source>
        <translation>Es gibt schon eine Datei dieses Namens.</translation>
    </message>
    <message>
        <source>there is no folder &quot;%1&quot;.</source>
        <translation>Es gibt keinen Ordner „%1“.</translation>
    </message>
    <message>
        <source>there is no such file.</source>
        <translation>Diese Datei gibt es nicht.</translation>
    </message>
    <message>
        <source>there is no such piece in it.</source>
        <translation>Ein solches Stück ist nicht darin.</translation>
    </message>
    <message>
        <source>there is not enough memory for it.</source>
        <translation>Der Arbeitsspeicher reicht nicht.</translation>
    </message>
    <message>
        <source>there is not enough memory.</source>
        <translation>Der Arbeitsspeicher reicht nicht.</translation>
    </message>
    <message>
        <source>they belong to a picture of another shape, %1 × %2 pixels.</source>
        <translation>Sie gehören zu einem Bild anderer Form, %1 × %2 Pixel.</translation>
    </message>
    <message>
        <source>they lie on different disks.</source>
        <translation>Sie liegen auf verschiedenen Datenträgern.</translation>
    </message>
    <message>
        <source>too small</source>
        <translation>zu klein</translation>
    </message>
    <message>
        <source>top and bottom edges</source>
        <translation>oberen und unteren Rand</translation>
    </message>
    <message>
        <source>top edge</source>
        <translation>oberen Rand</translation>
    </message>
    <message>
        <source>turned to the side</source>
        <translation>zur Seite gedreht</translation>
    </message>
    <message>
        <source>was written by a newer version of this program</source>
        <translation>wurde von einer neueren Version dieses Programms geschrieben</translation>
    </message>
    <message>
        <source>what was written is not what should have been written; the disk or the memory may be faulty.</source>
        <translation>Was geschrieben wurde, ist nicht, was geschrieben werden sollte; Datenträger oder Arbeitsspeicher sind vielleicht fehlerhaft.</translation>
    </message>
    <message>
        <source>you are not allowed to read it.</source>
        <translation>Sie dürfen die Datei nicht lesen.</translation>
    </message>
    <message>
        <source>you are not allowed to write there.</source>
        <translation>Sie dürfen dort nicht schreiben.</translation>
    </message>
    <message>
        <source>A calibration sample is not a valid place; touch the marks again.</source>
        <translation>Ein Messwert der Kalibrierung ist keine gültige Stelle; berühren Sie die Marken noch einmal.</translation>
    </message>
    <message>
        <source>The calibration could not be saved: %1</source>
        <translation>Die Kalibrierung konnte nicht gespeichert werden: %1</translation>
    </message>
    <message>
        <source>Too many touches do not fit together. Touch the marks again with the finger in the device, and with no other.</source>
        <translation>Zu viele Berührungen passen nicht zusammen. Berühren Sie die Marken noch einmal mit dem Finger im Gerät und mit keinem anderen.</translation>
    </message>
    <message>
        <source>the device has no name to keep it by.</source>
        <translation>das Gerät hat keinen Namen, unter dem sie gespeichert werden kann.</translation>
    </message>
    <message>
        <source>This device needs no homing.</source>
        <translation>Dieses Gerät braucht keinen Nullpunkt.</translation>
    </message>
    <message>
        <source>The force stick cannot be used: %1.</source>
        <translation>Der Kraftstick kann nicht benutzt werden: %1.</translation>
    </message>
    <message>
        <source>The force stick does not take up a force. Unplug it and plug it in again.</source>
        <translation>Der Kraftstick nimmt keine Kraft an. Ziehen Sie ihn ab und schließen Sie ihn wieder an.</translation>
    </message>
    <message>
        <source>The force stick does not take what this computer sends. It goes on by itself when it does.</source>
        <translation>Der Kraftstick nimmt nicht an, was dieser Computer sendet. Sobald er es wieder tut, geht es von selbst weiter.</translation>
    </message>
    <message>
        <source>The force stick has no room for a force. Close other programs that use it, unplug it and plug it in again.</source>
        <translation>Der Kraftstick hat keinen Platz für eine Kraft. Schließen Sie andere Programme, die ihn benutzen, ziehen Sie ihn ab und schließen Sie ihn wieder an.</translation>
    </message>
    <message>
        <source>The force stick has switched its motors off. Check that its power supply is plugged in and that no other program uses it.</source>
        <translation>Der Kraftstick hat seine Motoren abgeschaltet. Prüfen Sie, ob sein Netzteil angeschlossen ist und ob kein anderes Programm ihn benutzt.</translation>
    </message>
    <message>
        <source>The force stick&apos;s safety switch keeps its motors off. Hold the grip as its maker says, or release the switch.</source>
        <translation>Der Sicherheitsschalter des Kraftsticks hält seine Motoren aus. Halten Sie den Griff so, wie der Hersteller es vorsieht, oder lösen Sie den Schalter.</translation>
    </message>
    <message>
        <source>force stick</source>
        <translation>Kraftstick</translation>
    </message>
    <message>
        <source>it does not have two axes</source>
        <translation>er hat keine zwei Achsen</translation>
    </message>
    <message>
        <source>it does not keep its effects itself</source>
        <translation>er verwaltet seine Effekte nicht selbst</translation>
    </message>
    <message>
        <source>it has no constant force</source>
        <translation>er kennt keine gleichbleibende Kraft</translation>
    </message>
    <message>
        <source>its effects have no numbers</source>
        <translation>seine Effekte haben keine Nummern</translation>
    </message>
    <message>
        <source>its force has no direction</source>
        <translation>seine Kraft hat keine Richtung</translation>
    </message>
    <message>
        <source>its force has no sign</source>
        <translation>seine Kraft hat kein Vorzeichen</translation>
    </message>
    <message>
        <source>its reports are too long</source>
        <translation>seine Berichte sind zu lang</translation>
    </message>
    <message>
        <source>what it reports of itself makes no sense</source>
        <translation>was er von sich meldet, ergibt keinen Sinn</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not say in what language a name is read: %2 Move it away, then choose the language again.</source>
        <translation>„%1“ sagt nicht, in welcher Sprache ein Name gelesen wird: %2 Verschieben Sie die Datei und wählen Sie die Sprache dann neu.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a language tag, such as de or pt-BR.</source>
        <translation>„%1“ ist kein Kürzel einer Sprache wie de oder pt-BR.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; says how the name of %2 is read, but is not in its place.</source>
        <translation>„%1“ sagt, wie der Name von %2 gelesen wird, liegt aber nicht an seinem Platz.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; says what to import, but this computer did not note it; it is left alone. Import the photographs themselves again; nothing comes twice.</source>
        <translation>„%1“ sagt, was zu importieren ist, aber dieser Computer hat das nicht notiert; es bleibt unangetastet. Importieren Sie die Fotos selbst noch einmal; nichts kommt doppelt.</translation>
    </message>
    <message>
        <source>A person needs a name before its language can be chosen.</source>
        <translation>Eine Person braucht einen Namen, bevor dessen Sprache gewählt werden kann.</translation>
    </message>
    <message>
        <source>The language of the name cannot be saved: %1</source>
        <translation>Die Sprache des Namens kann nicht gespeichert werden: %1</translation>
    </message>
    <message>
        <source>its first line is not a language tag, such as de or pt-BR.</source>
        <translation>die erste Zeile ist kein Kürzel einer Sprache wie de oder pt-BR.</translation>
    </message>
    <message>
        <source>its second line does not say whose name it is.</source>
        <translation>die zweite Zeile sagt nicht, wessen Name es ist.</translation>
    </message>
    <message>
        <source>the language of the name of %1</source>
        <translation>die Sprache des Namens von %1</translation>
    </message>
    <message>
        <source>the language of the name of %1 was chosen</source>
        <translation>die Sprache des Namens von %1 wurde gewählt</translation>
    </message>
    <message>
        <source>the language of the name of %1 became that of %2</source>
        <translation>die Sprache des Namens von %1 wurde zu der von %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not the firmware of a Falcon: it is too small. Copy the right file there.</source>
        <translation>„%1“ ist nicht die Firmware eines Falcon: Die Datei ist zu klein. Kopieren Sie die richtige Datei dorthin.</translation>
    </message>
    <message>
        <source>Novint Falcon</source>
        <translation>Novint Falcon</translation>
    </message>
    <message>
        <source>The Falcon did not take its firmware, though it was tried again and again. Plug its USB cable into this computer itself, not into a hub, and try once more.</source>
        <translation>Der Falcon hat seine Firmware nicht angenommen, obwohl es immer wieder versucht wurde. Schließen Sie das USB-Kabel direkt an diesen Computer an, nicht an einen Hub, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The Falcon does not answer. Check that it is plugged in and has power, and try again.</source>
        <translation>Der Falcon antwortet nicht. Prüfen Sie, ob er angeschlossen ist und Strom hat, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The Falcon does not answer. Check that its power supply is plugged in, unplug its USB cable, plug it in again and try once more.</source>
        <translation>Der Falcon antwortet nicht. Prüfen Sie, ob sein Netzteil angeschlossen ist, ziehen Sie das USB-Kabel ab und schließen Sie es wieder an, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The Falcon does not know where its grip is. Home it: pull the grip out as far as it goes, then push it in.</source>
        <translation>Der Falcon weiß nicht, wo sein Griff ist. Setzen Sie seinen Nullpunkt: Ziehen Sie den Griff heraus, so weit er geht, und schieben Sie ihn dann hinein.</translation>
    </message>
    <message>
        <source>The Falcon is not homed yet. Home it again, and while its light is blue pull the grip out as far as it goes, then push it in.</source>
        <translation>Der Nullpunkt des Falcon ist noch nicht gesetzt. Setzen Sie ihn noch einmal, und ziehen Sie, solange das Licht blau ist, den Griff heraus, so weit er geht, und schieben Sie ihn dann hinein.</translation>
    </message>
    <message>
        <source>The Falcon needs its firmware, which its maker does not let this program include. Copy the firmware file of its maker&apos;s software to %1.</source>
        <translation>Der Falcon braucht seine Firmware, die dieses Programm nicht mitbringen darf. Kopieren Sie die Firmware-Datei aus der Software des Herstellers nach %1.</translation>
    </message>
    <message>
        <source>The Falcon took its firmware and does not answer. Perhaps %1 is not the firmware of a Falcon.</source>
        <translation>Der Falcon hat seine Firmware angenommen und antwortet nicht. Vielleicht ist %1 nicht die Firmware eines Falcon.</translation>
    </message>
    <message>
        <source>The Falcon was unplugged while it was started. Plug it in again.</source>
        <translation>Der Falcon wurde beim Starten abgezogen. Schließen Sie ihn wieder an.</translation>
    </message>
    <message>
        <source>Another program or the system keeps the %1 from this one. Close other programs that use it, unplug it and plug it in again.</source>
        <translation>Ein anderes Programm oder das System gibt das Gerät „%1“ nicht frei. Schließen Sie andere Programme, die es benutzen, ziehen Sie es ab und schließen Sie es wieder an.</translation>
    </message>
    <message>
        <source>Arduino board: a Haply 2diy of the first generation?</source>
        <translation>Arduino-Platine: ein Haply 2diy der ersten Generation?</translation>
    </message>
    <message>
        <source>Arduino board: a Haply 2diy of the third generation?</source>
        <translation>Arduino-Platine: ein Haply 2diy der dritten Generation?</translation>
    </message>
    <message>
        <source>The Haply 2diy could not be homed. Check that it is plugged in and switched on, and try again.</source>
        <translation>Der Nullpunkt des Haply 2diy konnte nicht gesetzt werden. Prüfen Sie, ob er angeschlossen und eingeschaltet ist, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The Haply 2diy does not know where its arms are. Put both arms on their marks and home it.</source>
        <translation>Der Haply 2diy weiß nicht, wo seine Arme sind. Stellen Sie beide Arme auf ihre Marken, und setzen Sie dann den Nullpunkt des Geräts.</translation>
    </message>
    <message>
        <source>The Haply 2diy lost count of where its arms are. Put both arms on their marks and home it.</source>
        <translation>Der Haply 2diy weiß nicht mehr, wo seine Arme sind. Stellen Sie beide Arme auf ihre Marken, und setzen Sie dann den Nullpunkt des Geräts.</translation>
    </message>
    <message>
        <source>The device at the serial port does not answer like a Haply 2diy. Switch it on, unplug it and plug it in again; if it is not a Haply 2diy, choose another device.</source>
        <translation>Das Gerät am seriellen Anschluss antwortet nicht wie ein Haply 2diy. Schalten Sie es ein, ziehen Sie es ab und schließen Sie es wieder an; wenn es kein Haply 2diy ist, wählen Sie ein anderes Gerät.</translation>
    </message>
    <message>
        <source>The device stays off, because nothing would watch over its motors on this system.</source>
        <translation>Das Gerät bleibt aus, weil auf diesem System nichts über seine Motoren wachen würde.</translation>
    </message>
    <message>
        <source>The device stays off, because the program that watches over its motors, touchphoto-force-guard, does not start. Install TouchPhoto again.</source>
        <translation>Das Gerät bleibt aus, weil das Programm, das über seine Motoren wacht, touchphoto-force-guard, nicht startet. Installieren Sie TouchPhoto neu.</translation>
    </message>
    <message>
        <source>The device stays off, because the program that watches over its motors, touchphoto-force-guard, is missing. Install TouchPhoto again.</source>
        <translation>Das Gerät bleibt aus, weil das Programm, das über seine Motoren wacht, touchphoto-force-guard, fehlt. Installieren Sie TouchPhoto neu.</translation>
    </message>
    <message>
        <source>The program that watches over the motors of the Haply 2diy has ended, so they stay off. Start the device again.</source>
        <translation>Das Programm, das über die Motoren des Haply 2diy wacht, wurde beendet, darum bleiben sie aus. Starten Sie das Gerät neu.</translation>
    </message>
    <message>
        <source>This computer has no room for the program that watches over the motors. Close other programs and try again.</source>
        <translation>Auf diesem Computer ist kein Platz für das Programm, das über die Motoren wacht. Schließen Sie andere Programme und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>You are not allowed to use the %1 yet. Copy resources/udev/70-touchphoto.rules to /etc/udev/rules.d, then unplug the device and plug it in again; or have yourself added to the group dialout and log in again.</source>
        <translation>Sie dürfen das Gerät „%1“ noch nicht benutzen. Kopieren Sie resources/udev/70-touchphoto.rules nach /etc/udev/rules.d, ziehen Sie das Gerät dann ab und schließen Sie es wieder an; oder lassen Sie sich in die Gruppe dialout aufnehmen und melden Sie sich neu an.</translation>
    </message>
    <message>
        <source>it holds &quot;%1&quot;, which is packed in an unusual way. Pack it again as an ordinary ZIP file.</source>
        <translation>Es enthält „%1“, das auf ungewöhnliche Weise gepackt ist. Packen Sie es noch einmal als gewöhnliche ZIP-Datei.</translation>
    </message>
    <message>
        <source>A stick cannot be as strong or as weak as that. Check that the scale shows grams and pulls straight towards you, and weigh again.</source>
        <translation>So stark oder so schwach kann ein Kraftstick nicht sein. Achten Sie darauf, dass die Waage Gramm zeigt und gerade auf Sie zu zieht, und wiegen Sie noch einmal.</translation>
    </message>
    <message>
        <source>The stick does not pull now. Hold the grip where it is, and weigh again.</source>
        <translation>Der Kraftstick zieht gerade nicht. Halten Sie den Griff, wo er ist, und wiegen Sie noch einmal.</translation>
    </message>
    <message>
        <source>What the scale shows must be a number of grams from 0 to 100000.</source>
        <translation>Was die Waage zeigt, muss eine Zahl von 0 bis 100000 Gramm sein.</translation>
    </message>
    <message>
        <source>What was measured of the stick could not be saved: %1</source>
        <translation>Was am Kraftstick gemessen wurde, konnte nicht gespeichert werden: %1</translation>
    </message>
    <message>
        <source>What was unpacked for the import cannot be removed: %1</source>
        <translation>Was für den Import entpackt wurde, kann nicht entfernt werden: %1</translation>
    </message>
    <message>
        <source>the stick has no name to keep it by.</source>
        <translation>der Kraftstick hat keinen Namen, unter dem es sich speichern ließe.</translation>
    </message>
    <message>
        <source>there is no folder for settings.</source>
        <translation>es gibt keinen Ordner für Einstellungen.</translation>
    </message>
    <message>
        <source>The program that watches over the motors of the force stick has ended, so they stay off. Start the device again.</source>
        <translation>Das Programm, das über die Motoren des Kraftsticks wacht, wurde beendet, darum bleiben sie aus. Starten Sie das Gerät neu.</translation>
    </message>
    <message>
        <source>The program that watches over the motors of the Falcon has ended, so they stay off. Start the device again.</source>
        <translation>Das Programm, das über die Motoren des Falcon wacht, wurde beendet, darum bleiben sie aus. Starten Sie das Gerät neu.</translation>
    </message>
    <message>
        <source>Pictures in the formats HEIC and AVIF need the library libheif (Debian: libheif1), which is not installed: install it or save the picture as JPEG.</source>
        <translation>Für Bilder in den Formaten HEIC und AVIF fehlt die Bibliothek libheif (Debian: libheif1): Installieren Sie sie oder speichern Sie das Bild als JPEG.</translation>
    </message>
    <message>
        <source>The %1 file holds a kind of picture that cannot be decoded here: save it as JPEG.</source>
        <translation>Die %1-Datei enthält eine Art von Bild, die hier nicht decodiert werden kann: Speichern Sie es als JPEG.</translation>
    </message>
    <message>
        <source>The %1 file is cut short: a part of the picture is missing.</source>
        <translation>Die %1-Datei ist abgeschnitten: Ein Teil des Bildes fehlt.</translation>
    </message>
    <message>
        <source>The %1 file says that it holds more than any photograph does; it was not read.</source>
        <translation>Die %1-Datei gibt an, mehr zu enthalten als je ein Foto; sie wurde nicht gelesen.</translation>
    </message>
    <message>
        <source>The raw file holds no preview that can be read: save the picture as JPEG.</source>
        <translation>Die Raw-Datei enthält keine Vorschau, die gelesen werden kann: Speichern Sie das Bild als JPEG.</translation>
    </message>
    <message>
        <source>A beard hides the jaw, so the outline may be wrong.</source>
        <translation>Ein Bart verdeckt den Kiefer, der Gesichtsumriss könnte deshalb falsch sein.</translation>
    </message>
    <message>
        <source>Hair hides the jaw, so the outline may be wrong.</source>
        <translation>Haare verdecken den Kiefer, der Gesichtsumriss könnte deshalb falsch sein.</translation>
    </message>
    <message>
        <source>a beard hides it</source>
        <translation>von einem Bart verdeckt</translation>
    </message>
    <message>
        <source>hair hides it</source>
        <translation>von Haaren verdeckt</translation>
    </message>
    <message>
        <source>The picture %1 could not be written: %2</source>
        <translation>Das Bild %1 konnte nicht geschrieben werden: %2</translation>
    </message>
    <message>
        <source>it holds &quot;%1&quot; twice.</source>
        <translation>Es enthält „%1“ zweimal.</translation>
    </message>
    <message>
        <source>it holds no photograph.</source>
        <translation>Es enthält kein Foto.</translation>
    </message>
    <message>
        <source>the picture is empty, or its ending is neither png nor jpg.</source>
        <translation>Das Bild ist leer, oder seine Endung ist weder png noch jpg.</translation>
    </message>
    <message>
        <source>That is more than can be imported at once: import the folder that the files are in.</source>
        <translation>Das ist mehr, als auf einmal importiert werden kann: Importieren Sie den Ordner, in dem die Dateien liegen.</translation>
    </message>
    <message>
        <source>it lists more people, words or recordings than any photograph has.</source>
        <translation>Die Datei zählt mehr Personen, Wörter oder Aufnahmen auf, als irgendein Foto hat.</translation>
    </message>
    <message>
        <source>Such files are decoded in a process that can do nothing else, and this system does not allow that (%1): save the picture as JPEG.</source>
        <translation>Solche Dateien werden in einem Prozess decodiert, der sonst nichts kann, und dieses System lässt das nicht zu (%1): Speichern Sie das Bild als JPEG.</translation>
    </message>
    <message>
        <source>The picture cannot be decoded: decoding it broke off. The file may be damaged.</source>
        <translation>Das Bild kann nicht decodiert werden: Das Decodieren brach ab. Die Datei ist vielleicht beschädigt.</translation>
    </message>
    <message>
        <source>The picture takes too long to decode; it was not read.</source>
        <translation>Das Decodieren des Bildes dauert zu lange; es wurde nicht gelesen.</translation>
    </message>
    <message>
        <source>The program %1, which decodes such files, cannot be started: install TouchPhoto again.</source>
        <translation>Das Programm %1, das solche Dateien decodiert, lässt sich nicht starten: Installieren Sie TouchPhoto neu.</translation>
    </message>
    <message>
        <source>its sound cannot be decoded: decoding it broke off. It may be damaged.</source>
        <translation>Der Ton kann nicht decodiert werden: Das Decodieren brach ab. Vielleicht ist er beschädigt.</translation>
    </message>
    <message>
        <source>its sound takes too long to decode.</source>
        <translation>Das Decodieren des Tons dauert zu lange.</translation>
    </message>
    <message>
        <source>it is not a photograph of a kind that can be read here.</source>
        <translation>es ist kein Foto, das hier gelesen werden kann.</translation>
    </message>
    <message>
        <source>%1 faces were named %2</source>
        <translation>%1 Gesichter heißen jetzt %2</translation>
    </message>
    <message>
        <source>Since then the groups of faces have changed, so this cannot be undone.</source>
        <translation>Seitdem haben sich die Gruppen der Gesichter geändert, daher lässt sich das nicht rückgängig machen.</translation>
    </message>
    <message>
        <source>These faces are not grouped so any more.</source>
        <translation>Diese Gesichter sind nicht mehr so gruppiert.</translation>
    </message>
    <message>
        <source>a face is not that of %1</source>
        <translation>ein Gesicht ist nicht das von %1</translation>
    </message>
    <message>
        <source>a face was taken out of its group</source>
        <translation>ein Gesicht wurde aus seiner Gruppe genommen</translation>
    </message>
    <message>
        <source>Another program is using the camera. Close it and try again.</source>
        <translation>Ein anderes Programm benutzt die Kamera. Schließen Sie es und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>No camera was found on this computer.</source>
        <translation>Auf diesem Computer wurde keine Kamera gefunden.</translation>
    </message>
    <message>
        <source>The camera gives no pictures.</source>
        <translation>Die Kamera liefert keine Bilder.</translation>
    </message>
    <message>
        <source>The camera gives pictures that TouchPhoto cannot read.</source>
        <translation>Die Kamera liefert Bilder, die TouchPhoto nicht lesen kann.</translation>
    </message>
    <message>
        <source>The camera was unplugged.</source>
        <translation>Die Kamera wurde abgezogen.</translation>
    </message>
    <message>
        <source>The system does not let TouchPhoto use the camera.</source>
        <translation>Das System lässt TouchPhoto die Kamera nicht benutzen.</translation>
    </message>
    <message>
        <source>the recording of background sounds</source>
        <translation>die Aufnahme der Umgebungsgeräusche</translation>
    </message>
    <message>
        <source>the recording of background sounds (%1)</source>
        <translation>die Aufnahme der Umgebungsgeräusche (%1)</translation>
    </message>
    <message>
        <source>the recording of the place</source>
        <translation>die Ortsaufnahme</translation>
    </message>
    <message>
        <source>the recording of the place (%1)</source>
        <translation>die Ortsaufnahme (%1)</translation>
    </message>
    <message>
        <source>the recording of who %1 is</source>
        <translation>die Aufnahme zu %1</translation>
    </message>
    <message>
        <source>the recording of who it is</source>
        <translation>die Aufnahme zur Person</translation>
    </message>
    <message>
        <source>it was changed meanwhile.</source>
        <translation>sie wurde inzwischen geändert.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be gone on with: its trial %2 is not the one that the study has planned.</source>
        <translation>Mit „%1“ kann es nicht weitergehen: Durchgang %2 darin ist nicht der, den die Studie vorgesehen hat.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has the trials of participant %2; name it &quot;%3&quot;.</source>
        <translation>„%1“ enthält die Durchgänge von Person %2; nennen Sie die Datei „%3“.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: the last trial was being written when the program ended; it is done again.</source>
        <translation>„%1“: Der letzte Durchgang wurde gerade geschrieben, als das Programm endete; er wird wiederholt.</translation>
    </message>
    <message>
        <source>Another program is running the study in &quot;%1&quot;; end it there, or choose another folder.</source>
        <translation>Ein anderes Programm führt gerade die Studie in „%1“ durch; beenden Sie sie dort, oder wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>In &quot;%1&quot; lies a study of another experiment, or of another version of it; choose another folder for this one.</source>
        <translation>In „%1“ liegt eine Studie zu einem anderen Experiment oder einer anderen Fassung davon; wählen Sie für diese einen anderen Ordner.</translation>
    </message>
    <message>
        <source>In &quot;%1&quot; lies a study with another seed or other participants; choose another folder for this one.</source>
        <translation>In „%1“ liegt eine Studie mit anderer Startzahl oder anderen Teilnehmenden; wählen Sie für diese einen anderen Ordner.</translation>
    </message>
    <message>
        <source>Line %1 of the study&apos;s terms %2.</source>
        <translation>Zeile %1 der Festlegungen der Studie %2.</translation>
    </message>
    <message>
        <source>Line %1 of the table of sittings %2.</source>
        <translation>Zeile %1 der Tabelle der Sitzungen %2.</translation>
    </message>
    <message>
        <source>Participant %1: %2 trials of %3, %4 of them done again.</source>
        <translation>Person %1: %2 von %3 Durchgängen, %4 davon wiederholt.</translation>
    </message>
    <message>
        <source>Participant %1: %2 trials of %3, %4 of them done again; %5 are missing.</source>
        <translation>Person %1: %2 von %3 Durchgängen, %4 davon wiederholt; %5 fehlen.</translation>
    </message>
    <message>
        <source>Participant %1: %2 trials of %3.</source>
        <translation>Person %1: %2 von %3 Durchgängen.</translation>
    </message>
    <message>
        <source>Participant %1: %2 trials of %3; %4 are missing.</source>
        <translation>Person %1: %2 von %3 Durchgängen; %4 fehlen.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be read.</source>
        <translation>Der Ordner „%1“ kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; has other files in it; a study begins in an empty one.</source>
        <translation>Im Ordner „%1“ liegen andere Dateien; eine Studie beginnt in einem leeren.</translation>
    </message>
    <message>
        <source>The study cannot write &quot;%1&quot;: %2</source>
        <translation>Die Studie kann „%1“ nicht schreiben: %2</translation>
    </message>
    <message>
        <source>The study has more than %1 participants.</source>
        <translation>Die Studie hat mehr als %1 Teilnehmende.</translation>
    </message>
    <message>
        <source>The study in &quot;%1&quot; cannot go on: its file &quot;%2&quot; is missing.</source>
        <translation>Die Studie in „%1“ kann nicht weitergehen: Ihre Datei „%2“ fehlt.</translation>
    </message>
    <message>
        <source>The study&apos;s terms do not say who takes part: a line &quot;participants: people&quot; or &quot;participants: simulated&quot; is missing.</source>
        <translation>Die Festlegungen der Studie sagen nicht, wer teilnimmt: Eine Zeile „participants: people“ oder „participants: simulated“ fehlt.</translation>
    </message>
    <message>
        <source>The study&apos;s terms have no seed: a line &quot;seed: NUMBER&quot; is missing.</source>
        <translation>In den Festlegungen der Studie fehlt die Startzahl: eine Zeile „seed: ZAHL“.</translation>
    </message>
    <message>
        <source>The table of sittings has other columns than %1.</source>
        <translation>Die Tabelle der Sitzungen hat andere Spalten als %1.</translation>
    </message>
    <message>
        <source>The table of sittings is longer than %1 MB.</source>
        <translation>Die Tabelle der Sitzungen ist länger als %1 MB.</translation>
    </message>
    <message>
        <source>The terms of the study are longer than %1 KB.</source>
        <translation>Die Festlegungen der Studie sind länger als %1 KB.</translation>
    </message>
    <message>
        <source>The trial was not kept: it is not the one that comes next.</source>
        <translation>Der Durchgang wurde nicht gespeichert: Er ist nicht der, der als nächster kommt.</translation>
    </message>
    <message>
        <source>The trial was not kept: the finger&apos;s path in it is none.</source>
        <translation>Der Durchgang wurde nicht gespeichert: Der Weg des Fingers darin ist keiner.</translation>
    </message>
    <message>
        <source>There is no study in &quot;%1&quot;.</source>
        <translation>In „%1“ liegt keine Studie.</translation>
    </message>
    <message>
        <source>has another number of cells than there are columns</source>
        <translation>hat eine andere Zahl von Zellen, als es Spalten gibt</translation>
    </message>
    <message>
        <source>is not understood</source>
        <translation>wird nicht verstanden</translation>
    </message>
    <message>
        <source>it is gone.</source>
        <translation>sie ist nicht mehr da.</translation>
    </message>
    <message>
        <source>needs a whole number</source>
        <translation>braucht eine ganze Zahl</translation>
    </message>
    <message>
        <source>needs people or simulated</source>
        <translation>braucht „people“ oder „simulated“</translation>
    </message>
    <message>
        <source>needs whole numbers from 1 to 1000000 in its first two cells</source>
        <translation>braucht in den ersten zwei Zellen ganze Zahlen von 1 bis 1000000</translation>
    </message>
    <message>
        <source>participant %1 is in &quot;%2&quot; already.</source>
        <translation>Person %1 steht schon in „%2“.</translation>
    </message>
    <message>
        <source>says it a second time</source>
        <translation>sagt es ein zweites Mal</translation>
    </message>
    <message>
        <source>the last trial was being written when the program ended; it is left out.</source>
        <translation>der letzte Durchgang wurde gerade geschrieben, als das Programm endete; er ist nicht dabei.</translation>
    </message>
    <message>
        <source>the trials of more than one participant are in it.</source>
        <translation>sie enthält Durchgänge von mehr als einer Person.</translation>
    </message>
    <message>
        <source>A face cannot be followed from a start to an end; the experiment %1 needs the task: name.</source>
        <translation>Einem Gesicht kann man nicht von einem Anfang zu einem Ende folgen; das Experiment %1 braucht die Aufgabe „name“.</translation>
    </message>
    <message>
        <source>A shape %1 mm wide and %2 mm high does not fit on a surface of %3 x %4 mm.</source>
        <translation>Eine Form von %1 mm Breite und %2 mm Höhe passt nicht auf eine Fläche von %3 x %4 mm.</translation>
    </message>
    <message>
        <source>The experiment %1 must have either a path, a shape or a face in every trial, as a factor or set for all.</source>
        <translation>Das Experiment %1 muss in jedem Durchgang entweder einen Weg, eine Form oder ein Gesicht haben, als Faktor oder für alle festgelegt.</translation>
    </message>
    <message>
        <source>The experiment %1 needs faces, and none are there.</source>
        <translation>Das Experiment %1 braucht Gesichter, aber es sind keine da.</translation>
    </message>
    <message>
        <source>The trial was not kept: a study has at most %1 participants.</source>
        <translation>Der Durchgang wurde nicht gespeichert: Eine Studie hat höchstens %1 Teilnehmende.</translation>
    </message>
    <message>
        <source>The trial was not kept: its error, time or answer is none that there can be.</source>
        <translation>Der Durchgang wurde nicht gespeichert: Fehler, Zeit oder Antwort darin kann es so nicht geben.</translation>
    </message>
    <message>
        <source>A face of the experiment is not there.</source>
        <translation>Ein Gesicht des Experiments ist nicht da.</translation>
    </message>
    <message>
        <source>No face was found in &quot;%1&quot;.</source>
        <translation>In „%1“ wurde kein Gesicht gefunden.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; has too few people with every expression: %2. Name the files after person and expression, such as anna_smiling.jpg.</source>
        <translation>Im Ordner „%1“ haben zu wenige Personen alle Ausdrücke: %2. Benennen Sie die Dateien nach Person und Ausdruck, etwa anna_smiling.jpg.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; has too many files.</source>
        <translation>Im Ordner „%1“ liegen zu viele Dateien.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; belongs to no trial that was kept.</source>
        <translation>„%1“ gehört zu keinem gespeicherten Durchgang.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has %2 samples; in the trial&apos;s time there are %3 at least.</source>
        <translation>„%1“ hat %2 Messwerte; in der Zeit des Durchgangs müssten es mindestens %3 sein.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was being written when the program ended; it goes when the study goes on.</source>
        <translation>„%1“ wurde gerade geschrieben, als das Programm endete; die Datei verschwindet, wenn die Studie weitergeht.</translation>
    </message>
    <message>
        <source>A trial was running when the program ended; it is done again.</source>
        <translation>Als das Programm endete, lief gerade ein Durchgang; er wird wiederholt.</translation>
    </message>
    <message>
        <source>Line %1 of the finger&apos;s path goes back in time.</source>
        <translation>Zeile %1 des Fingerwegs geht in der Zeit zurück.</translation>
    </message>
    <message>
        <source>Line %1 of the finger&apos;s path has no five numbers.</source>
        <translation>Zeile %1 des Fingerwegs hat keine fünf Zahlen.</translation>
    </message>
    <message>
        <source>Participant %1: nobody has noted with which machine the first trial was done.</source>
        <translation>Person %1: Es ist nicht vermerkt, mit welchem Gerät der erste Durchgang gemacht wurde.</translation>
    </message>
    <message>
        <source>Participant %1: the finger&apos;s path is missing in these trials: %2.</source>
        <translation>Person %1: In diesen Durchgängen fehlt der Weg des Fingers: %2.</translation>
    </message>
    <message>
        <source>Participant %1: trial %2 is not the one that was planned; protocol, seed or table were changed since.</source>
        <translation>Person %1: Durchgang %2 ist nicht der geplante; Protokoll, Startzahl oder Tabelle wurden seitdem geändert.</translation>
    </message>
    <message>
        <source>The finger&apos;s path cannot be unpacked: %1</source>
        <translation>Der Weg des Fingers kann nicht entpackt werden: %1</translation>
    </message>
    <message>
        <source>The finger&apos;s path has more than %1 samples.</source>
        <translation>Der Weg des Fingers hat mehr als %1 Messwerte.</translation>
    </message>
    <message>
        <source>The finger&apos;s path has other columns than time_s,x_mm,y_mm,fx_n,fy_n.</source>
        <translation>Der Weg des Fingers hat andere Spalten als time_s,x_mm,y_mm,fx_n,fy_n.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be made: %2</source>
        <translation>Der Ordner „%1“ kann nicht angelegt werden: %2</translation>
    </message>
    <message>
        <source>The last line of the finger&apos;s path is not whole.</source>
        <translation>Die letzte Zeile des Fingerwegs ist nicht vollständig.</translation>
    </message>
    <message>
        <source>The line %1 reaches more than 1 km from the middle of the surface, too far to be felt exactly.</source>
        <translation>Die Linie %1 reicht mehr als 1 km von der Mitte der Fläche weg, zu weit, um genau gefühlt zu werden.</translation>
    </message>
    <message>
        <source>The page &quot;%1&quot; cannot be written: %2</source>
        <translation>Die Seite „%1“ kann nicht geschrieben werden: %2</translation>
    </message>
    <message>
        <source>The plot %1 cannot be written: %2</source>
        <translation>Das Diagramm %1 kann nicht geschrieben werden: %2</translation>
    </message>
    <message>
        <source>The table %1 cannot be written: %2</source>
        <translation>Die Tabelle %1 kann nicht geschrieben werden: %2</translation>
    </message>
    <message>
        <source>There is no file &quot;%1&quot;: nobody knows the seed of the study, or whether its participants are simulated.</source>
        <translation>Die Datei „%1“ fehlt: Niemand kennt die Startzahl der Studie oder weiß, ob die Versuchspersonen simuliert sind.</translation>
    </message>
    <message>
        <source>it ends too soon.</source>
        <translation>sie endet zu früh.</translation>
    </message>
    <message>
        <source>it holds more than such a file may.</source>
        <translation>sie enthält mehr, als eine solche Datei darf.</translation>
    </message>
    <message>
        <source>there is something behind its end.</source>
        <translation>hinter ihrem Ende steht noch etwas.</translation>
    </message>
    <message>
        <source>The video &quot;%1&quot; cannot be played: %2</source>
        <translation>Das Video „%1“ kann nicht abgespielt werden: %2</translation>
    </message>
    <message>
        <source>it has no pictures.</source>
        <translation>Es sind keine Bilder darin.</translation>
    </message>
    <message>
        <source>its pictures are of a kind that cannot be decoded here (%1).</source>
        <translation>Die Bilder sind von einer Art, die hier nicht decodiert werden kann (%1).</translation>
    </message>
    <message>
        <source>its pictures cannot be decoded.</source>
        <translation>Die Bilder können nicht decodiert werden.</translation>
    </message>
    <message>
        <source>its pictures cannot be decoded: decoding them broke off. It may be damaged.</source>
        <translation>Die Bilder können nicht decodiert werden: Das Decodieren brach ab. Vielleicht ist das Video beschädigt.</translation>
    </message>
    <message>
        <source>its pictures take too long to decode.</source>
        <translation>Das Decodieren der Bilder dauert zu lange.</translation>
    </message>
    <message>
        <source>nothing of its pictures can be decoded.</source>
        <translation>Keines der Bilder kann decodiert werden.</translation>
    </message>
    <message>
        <source>A friction map has between 0 and 1000 dots a millimetre.</source>
        <translation>Eine Reibungskarte hat mehr als 0 und höchstens 1000 Punkte je Millimeter.</translation>
    </message>
    <message>
        <source>A ridge of %1 mm is narrower than two dots at %2 dots a millimetre and would have gaps; choose more dots or a wider ridge.</source>
        <translation>Ein Wulst von %1 mm ist bei %2 Punkten je Millimeter schmaler als zwei Punkte und hätte Lücken; wählen Sie mehr Punkte oder einen breiteren Wulst.</translation>
    </message>
    <message>
        <source>At %1 dots a millimetre the map would be %2 × %3 dots, more than can be drawn; choose fewer dots a millimetre.</source>
        <translation>Bei %1 Punkten je Millimeter hätte die Karte %2 × %3 Punkte, mehr als gezeichnet werden können; wählen Sie weniger Punkte je Millimeter.</translation>
    </message>
    <message>
        <source>The friction of a ridge and of a stripe must be numbers from 0 to 1.</source>
        <translation>Die Reibung eines Wulstes und eines Streifens müssen Zahlen von 0 bis 1 sein.</translation>
    </message>
    <message>
        <source>The speed of a moving finger must be a number above that of a resting one.</source>
        <translation>Die Geschwindigkeit eines bewegten Fingers muss eine Zahl über der eines ruhenden sein.</translation>
    </message>
    <message>
        <source>The width of a ridge and of a stripe must be numbers of millimetres above zero.</source>
        <translation>Die Breite eines Wulstes und eines Streifens müssen Zahlen in Millimetern über null sein.</translation>
    </message>
    <message>
        <source>There is not enough memory for a map of so many dots; choose fewer dots a millimetre.</source>
        <translation>Für eine Karte mit so vielen Punkten reicht der Speicher nicht; wählen Sie weniger Punkte je Millimeter.</translation>
    </message>
    <message>
        <source>There is no touch output &quot;%1&quot; now. Check that it is plugged in; &quot;touchphoto-lab devices&quot; lists what is there.</source>
        <translation>Die Fühlausgabe „%1“ gibt es jetzt nicht. Prüfen Sie, ob sie angeschlossen ist; „touchphoto-lab devices“ zählt auf, was da ist.</translation>
    </message>
    <message>
        <source>No Steam Controller is switched on near its receiver. Press its middle button and try again.</source>
        <translation>In der Nähe des Empfängers ist kein Steam Controller eingeschaltet. Drücken Sie seine mittlere Taste und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Steam Controller</source>
        <translation>Steam Controller</translation>
    </message>
    <message>
        <source>Steam Controller by radio: its touch pads</source>
        <translation>Steam Controller über Funk: seine Touchpads</translation>
    </message>
    <message>
        <source>Steam Controller: its touch pads</source>
        <translation>Steam Controller: seine Touchpads</translation>
    </message>
    <message>
        <source>Steam Deck</source>
        <translation>Steam Deck</translation>
    </message>
    <message>
        <source>Steam Deck: its touch pads</source>
        <translation>Steam Deck: seine Touchpads</translation>
    </message>
    <message>
        <source>The %1 does not answer. Close other programs that use it, such as Steam, and try again.</source>
        <translation>Dieses Gerät antwortet nicht: %1. Schließen Sie andere Programme, die es benutzen, etwa Steam, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The %1 does not take the ticks. Close other programs that use it, such as Steam.</source>
        <translation>Dieses Gerät nimmt die Tastimpulse nicht an: %1. Schließen Sie andere Programme, die es benutzen, etwa Steam.</translation>
    </message>
    <message>
        <source>The Steam Controller was switched off, or is too far from its receiver. Press its middle button.</source>
        <translation>Der Steam Controller wurde ausgeschaltet oder ist zu weit von seinem Empfänger entfernt. Drücken Sie seine mittlere Taste.</translation>
    </message>
    <message>
        <source>The touch pad with haptics cannot be used: %1.</source>
        <translation>Das Touchpad mit Haptik kann nicht benutzt werden: %1.</translation>
    </message>
    <message>
        <source>The touch pad with haptics does not take the ticks. Close other programs that use it.</source>
        <translation>Das Touchpad mit Haptik nimmt die Tastimpulse nicht an. Schließen Sie andere Programme, die es benutzen.</translation>
    </message>
    <message>
        <source>it does not say which ticks it has</source>
        <translation>es sagt nicht, welche Tastimpulse es hat</translation>
    </message>
    <message>
        <source>it has no tick that ends by itself</source>
        <translation>es hat keinen Tastimpuls, der von selbst endet</translation>
    </message>
    <message>
        <source>it ticks by itself only and takes no ticks from a program</source>
        <translation>es gibt Tastimpulse nur von sich aus und nimmt von Programmen keine an</translation>
    </message>
    <message>
        <source>touch pad with haptics</source>
        <translation>Touchpad mit Haptik</translation>
    </message>
    <message>
        <source>what it says of its ticks cannot be right</source>
        <translation>was es über seine Tastimpulse sagt, kann nicht stimmen</translation>
    </message>
    <message>
        <source>what it says of itself cannot be read</source>
        <translation>was es über sich sagt, kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>Other programs use all that the %1 can play. Close them and try again.</source>
        <translation>Andere Programme benutzen dieses Gerät ganz: %1. Schließen Sie sie und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The %1 answers too slowly to tell of lines. Unplug it and plug it in again; if that does not help, choose another output.</source>
        <translation>Dieses Gerät antwortet zu langsam, um Linien fühlen zu lassen: %1. Ziehen Sie es ab und schließen Sie es wieder an; hilft das nicht, wählen Sie eine andere Fühlausgabe.</translation>
    </message>
    <message>
        <source>The %1 cannot be used on this system: its vibration is used on Linux only.</source>
        <translation>Dieses Gerät kann auf diesem System nicht benutzt werden: %1. Seine Vibration wird nur unter Linux benutzt.</translation>
    </message>
    <message>
        <source>The %1 did not play what it was told. Close other programs that use it, unplug it and plug it in again.</source>
        <translation>Dieses Gerät hat nicht gespielt, was es sollte: %1. Schließen Sie andere Programme, die es benutzen, ziehen Sie es ab und schließen Sie es wieder an.</translation>
    </message>
    <message>
        <source>drawn finger</source>
        <translation>gezeichneter Finger</translation>
    </message>
    <message>
        <source>game pad</source>
        <translation>Gamepad</translation>
    </message>
    <message>
        <source>vibration motor of this machine</source>
        <translation>Vibrationsmotor dieses Computers</translation>
    </message>
    <message>
        <source>vibration of this phone</source>
        <translation>Vibration dieses Telefons</translation>
    </message>
    <message>
        <source>Dark glasses hide the eyes, so their contours are a guess.</source>
        <translation>Eine Sonnenbrille verdeckt die Augen, deshalb sind ihre Konturen geraten.</translation>
    </message>
    <message>
        <source>dark glasses hide it</source>
        <translation>von einer Sonnenbrille verdeckt</translation>
    </message>
    <message>
        <source>The way after which a line is told of again must be a number of millimetres, zero or more.</source>
        <translation>Der Weg, nach dem eine Linie wieder gemeldet wird, muss eine Zahl in Millimetern sein, null oder mehr.</translation>
    </message>
    <message>
        <source>simulated motor</source>
        <translation>simulierter Motor</translation>
    </message>
    <message>
        <source>The file &quot;%1&quot; is larger than %2 KB; that is more than such a file may be.</source>
        <translation>Die Datei „%1“ ist größer als %2 KB; das ist mehr, als so eine Datei haben darf.</translation>
    </message>
    <message>
        <source>The conflict copy &quot;%1&quot; cannot be read: %2 It stays where it is.</source>
        <translation>Die Konfliktkopie „%1“ kann nicht gelesen werden: %2 Sie bleibt, wo sie ist.</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; of &quot;%2&quot; is another one in the album; that one stays.</source>
        <translation>Die Aufnahme „%1“ von „%2“ ist im Album eine andere; diese bleibt.</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; of &quot;%2&quot; was not imported: %3</source>
        <translation>Die Aufnahme „%1“ von „%2“ wurde nicht importiert: %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is hidden, and an album leaves what is hidden alone.</source>
        <translation>„%1“ ist versteckt, und ein Album lässt Verstecktes unangetastet.</translation>
    </message>
    <message>
        <source>The JPEG file goes over its picture more often than any program does; it was not read.</source>
        <translation>Die JPEG-Datei geht öfter über ihr Bild, als irgendein Programm es tut; sie wurde nicht gelesen.</translation>
    </message>
    <message>
        <source>The file &quot;%1&quot; cannot be read: %2</source>
        <translation>Die Datei „%1“ kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read: %2</source>
        <translation>„%1“ kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>%1 Nothing was exported.</source>
        <translation>%1 Es wurde nichts exportiert.</translation>
    </message>
    <message>
        <source>The recording cannot be restored: %1</source>
        <translation>Die Aufnahme kann nicht zurückgeholt werden: %1</translation>
    </message>
    <message>
        <source>The recordings of &quot;%1&quot; were not imported: %2</source>
        <translation>Die Aufnahmen zu „%1“ wurden nicht importiert: %2</translation>
    </message>
    <message>
        <source>The trash &quot;%1&quot; cannot be read: %2</source>
        <translation>Der Papierkorb „%1“ kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>What belongs to &quot;%1&quot; cannot be read: %2</source>
        <translation>Was zu „%1“ gehört, kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not in the trash any more.</source>
        <translation>„%1“ ist nicht mehr im Papierkorb.</translation>
    </message>
</context>
<context>
    <name>SettingsPage</name>
    <message>
        <source>Tab moves from setting to setting, Space or Enter changes one, the arrow keys move a slider. Control+Z undoes the last change. Every change is saved at once.</source>
        <translation>Mit Tab gehen Sie von Einstellung zu Einstellung, Leertaste oder Eingabetaste ändert eine, die Pfeiltasten bewegen einen Regler. Strg+Z macht die letzte Änderung rückgängig. Jede Änderung wird sofort gespeichert.</translation>
    </message>
    <message>
        <source>Speech and sound</source>
        <translation>Sprache und Ton</translation>
    </message>
    <message>
        <source>Who speaks</source>
        <translation>Wer spricht</translation>
    </message>
    <message>
        <source>Speed of speech</source>
        <translation>Sprechtempo</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Speed of recordings</source>
        <translation>Tempo der Aufnahmen</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1-fach</translation>
    </message>
    <message>
        <source>Sound effects</source>
        <translation>Signaltöne</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>Textgröße</translation>
    </message>
    <message>
        <source>%1 percent</source>
        <translation>%1 Prozent</translation>
    </message>
    <message>
        <source>Animations</source>
        <translation>Animationen</translation>
    </message>
    <message>
        <source>Who uses the tablet most</source>
        <translation>Wer das Tablet am meisten benutzt</translation>
    </message>
    <message>
        <source>What is felt</source>
        <translation>Was zu fühlen ist</translation>
    </message>
    <message>
        <source>Strongest force</source>
        <translation>Maximale Kraft</translation>
    </message>
    <message>
        <source>%1 newtons</source>
        <translation>%1 Newton</translation>
    </message>
    <message>
        <source>Try the force on a face</source>
        <translation>Kraft an einem Gesicht ausprobieren</translation>
    </message>
    <message>
        <source>Guide when there is no force</source>
        <translation>Führung, wenn keine Kraft wirkt</translation>
    </message>
    <message>
        <source>Brows</source>
        <translation>Augenbrauen</translation>
    </message>
    <message>
        <source>Nose</source>
        <translation>Nase</translation>
    </message>
    <message>
        <source>Irises</source>
        <translation>Iris</translation>
    </message>
    <message>
        <source>Folders of the album</source>
        <translation>Ordner des Albums</translation>
    </message>
    <message>
        <source>No folder yet.</source>
        <translation>Noch kein Ordner.</translation>
    </message>
    <message>
        <source>Remove %1 from the album</source>
        <translation>%1 aus dem Album entfernen</translation>
    </message>
    <message>
        <source>The photographs stay where they are</source>
        <translation>Die Fotos bleiben, wo sie sind</translation>
    </message>
    <message>
        <source>Add a folder</source>
        <translation>Ordner hinzufügen</translation>
    </message>
    <message>
        <source>What is stored about me</source>
        <translation>Was über mich gespeichert ist</translation>
    </message>
    <message>
        <source>Rebuild the index</source>
        <translation>Index neu aufbauen</translation>
    </message>
    <message>
        <source>All settings</source>
        <translation>Alle Einstellungen</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>Nichts rückgängig zu machen</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Key: Control+Z</source>
        <translation>Tasten: Strg+Z</translation>
    </message>
    <message>
        <source>Ask me the five questions again</source>
        <translation>Die fünf Fragen noch einmal stellen</translation>
    </message>
    <message>
        <source>Reset all settings</source>
        <translation>Alle Einstellungen zurücksetzen</translation>
    </message>
    <message>
        <source>The album&apos;s folders stay. Can be undone</source>
        <translation>Die Ordner des Albums bleiben. Kann rückgängig gemacht werden</translation>
    </message>
    <message>
        <source>Force device</source>
        <translation>Kraftgerät</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Calibrate the device on this screen</source>
        <translation>Gerät auf diesem Bildschirm kalibrieren</translation>
    </message>
    <message>
        <source>You touch the four corners of the screen with the device</source>
        <translation>Sie berühren mit dem Gerät die vier Ecken des Bildschirms</translation>
    </message>
    <message>
        <source>Try the strongest force</source>
        <translation>Maximale Kraft ausprobieren</translation>
    </message>
    <message>
        <source>The device pulls to the right and to the left for less than three seconds. Escape ends it</source>
        <translation>Das Gerät zieht weniger als drei Sekunden lang nach rechts und nach links. Escape beendet es</translation>
    </message>
    <message>
        <source>Home the device</source>
        <translation>Nullpunkt des Geräts setzen</translation>
    </message>
    <message>
        <source>Put its handle on the mark first, and leave it there</source>
        <translation>Stellen Sie erst seinen Griff auf die Marke und lassen Sie ihn dort</translation>
    </message>
    <message>
        <source>Measure the stick</source>
        <translation>Kraftstick messen</translation>
    </message>
    <message>
        <source>How strong it is and which way it pulls. You need a kitchen scale or a luggage scale</source>
        <translation>Wie stark er ist und wohin er zieht. Sie brauchen eine Küchenwaage oder eine Kofferwaage</translation>
    </message>
    <message>
        <source>Descriptions of photographs</source>
        <translation>Beschreibungen von Fotos</translation>
    </message>
    <message>
        <source>What is said first</source>
        <translation>Was zuerst genannt wird</translation>
    </message>
    <message>
        <source>Compare faces, to offer names</source>
        <translation>Gesichter vergleichen, um Namen vorzuschlagen</translation>
    </message>
    <message>
        <source>What ticks under the finger</source>
        <translation>Was unter dem Finger tickt</translation>
    </message>
    <message>
        <source>Strength of ticks</source>
        <translation>Stärke der Ticks</translation>
    </message>
    <message>
        <source>Sharpness of ticks</source>
        <translation>Schärfe der Ticks</translation>
    </message>
    <message>
        <source>How late ticks are felt</source>
        <translation>Wie spät Ticks gefühlt werden</translation>
    </message>
    <message>
        <source>%1 milliseconds</source>
        <translation>%1 Millisekunden</translation>
    </message>
    <message>
        <source>Feel a tick now</source>
        <translation>Einen Tick fühlen</translation>
    </message>
    <message>
        <source>I feel it</source>
        <translation>Ich fühle ihn</translation>
    </message>
    <message>
        <source>Measure how late ticks are felt</source>
        <translation>Messen, wie spät Ticks gefühlt werden</translation>
    </message>
    <message>
        <source>Key: Space</source>
        <translation>Taste: Leertaste</translation>
    </message>
    <message>
        <source>You press Space when you feel a tick</source>
        <translation>Bei jedem Tick, der zu fühlen ist, drücken Sie die Leertaste</translation>
    </message>
</context>
<context>
    <name>SetupView</name>
    <message>
        <source>Experiment</source>
        <translation>Experiment</translation>
    </message>
    <message>
        <source>Open an experiment&apos;s file</source>
        <translation>Datei eines Experiments öffnen</translation>
    </message>
    <message>
        <source>Another experiment is a file, not a program. Key: O</source>
        <translation>Ein weiteres Experiment ist eine Datei, kein Programm. Taste: O</translation>
    </message>
    <message>
        <source>Choose the folder with faces</source>
        <translation>Ordner mit Gesichtern auswählen</translation>
    </message>
    <message>
        <source>Photographs or drawings named after person and expression. Key: G</source>
        <translation>Fotos oder Zeichnungen, benannt nach Person und Ausdruck. Taste: G</translation>
    </message>
    <message>
        <source>Choose another folder for the study</source>
        <translation>Anderen Ordner für die Studie auswählen</translation>
    </message>
    <message>
        <source>One with this study in it is continued. Key: F</source>
        <translation>Liegt diese Studie darin, wird sie fortgesetzt. Taste: F</translation>
    </message>
    <message>
        <source>Previous participant</source>
        <translation>Vorherige Versuchsperson</translation>
    </message>
    <message>
        <source>Key: Minus</source>
        <translation>Taste: Minus</translation>
    </message>
    <message>
        <source>Next participant</source>
        <translation>Nächste Versuchsperson</translation>
    </message>
    <message>
        <source>Key: Plus</source>
        <translation>Taste: Plus</translation>
    </message>
    <message>
        <source>What moves the finger</source>
        <translation>Was den Finger bewegt</translation>
    </message>
    <message>
        <source>I consent to the force that this study asks for</source>
        <translation>Ich willige in die Kraft ein, die diese Studie verlangt</translation>
    </message>
    <message>
        <source>Show the scene, to try it out; nothing is kept</source>
        <translation>Szene zeigen, zum Ausprobieren; nichts wird gespeichert</translation>
    </message>
    <message>
        <source>Start with participant %1</source>
        <translation>Mit Versuchsperson %1 beginnen</translation>
    </message>
    <message>
        <source>Asks for consent first. Key: S</source>
        <translation>Fragt zuerst nach der Einwilligung. Taste: S</translation>
    </message>
    <message>
        <source>Faces: %1</source>
        <translation>Gesichter: %1</translation>
    </message>
    <message>
        <source>The study&apos;s folder: %1</source>
        <translation>Ordner der Studie: %1</translation>
    </message>
    <message>
        <source>The participant&apos;s number, in place of a name. Key: N</source>
        <translation>Nummer der Versuchsperson, anstelle eines Namens. Taste: N</translation>
    </message>
    <message>
        <source>How the study stands</source>
        <translation>Stand der Studie</translation>
    </message>
    <message>
        <source>Trials, errors and times so far, and what is wrong in the folder. Key: C</source>
        <translation>Durchgänge, Fehler und Zeiten bisher, und was im Ordner nicht stimmt. Taste: C</translation>
    </message>
    <message>
        <source>Make the report</source>
        <translation>Bericht erstellen</translation>
    </message>
    <message>
        <source>Tables, plots and a page, beside the study&apos;s folder. Key: R</source>
        <translation>Tabellen, Diagramme und eine Seite, neben dem Ordner der Studie. Taste: R</translation>
    </message>
</context>
<context>
    <name>ShellView</name>
    <message>
        <source>Home</source>
        <translation>Startseite</translation>
    </message>
    <message>
        <source>Key: Escape</source>
        <translation>Taste: Escape</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Says what you can do here. Key: F1</source>
        <translation>Sagt, was man hier tun kann. Taste: F1</translation>
    </message>
    <message>
        <source>Last sentence</source>
        <translation>Letzter Satz</translation>
    </message>
</context>
<context>
    <name>SidePanel</name>
    <message>
        <source>Explore</source>
        <translation>Erkunden</translation>
    </message>
    <message>
        <source>Under the finger: nothing</source>
        <translation>Unter dem Finger: nichts</translation>
    </message>
    <message>
        <source>Under the finger: %1</source>
        <translation>Unter dem Finger: %1</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>Rundgang beenden</translation>
    </message>
    <message>
        <source>Guided tour</source>
        <translation>Geführter Rundgang</translation>
    </message>
    <message>
        <source>Leads the finger once round the feature. Key: Space</source>
        <translation>Führt den Finger einmal um das Merkmal. Taste: Leertaste</translation>
    </message>
    <message>
        <source>Tour of the face</source>
        <translation>Rundgang durch das Gesicht</translation>
    </message>
    <message>
        <source>Leads the finger round every feature, naming each one first. Key: T</source>
        <translation>Führt den Finger um jedes Merkmal und nennt es vorher. Taste: T</translation>
    </message>
    <message>
        <source>Where am I?</source>
        <translation>Wo bin ich?</translation>
    </message>
    <message>
        <source>Says which face and feature, the direction and the distance. Key: W</source>
        <translation>Nennt Gesicht, Merkmal, Richtung und Abstand. Taste: W</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Force on</source>
        <translation>Kraft einschalten</translation>
    </message>
    <message>
        <source>Stops tour, speech and force. Key: Escape</source>
        <translation>Beendet Rundgang, Sprache und Kraft. Taste: Escape</translation>
    </message>
    <message>
        <source>Key: Enter</source>
        <translation>Taste: Eingabetaste</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>To the face, its eyes, its mouth, and back. Key: Z</source>
        <translation>Auf das Gesicht, seine Augen, seinen Mund und zurück. Taste: Z</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Key: Shift+Z</source>
        <translation>Tasten: Umschalt+Z</translation>
    </message>
    <message>
        <source>Next feature</source>
        <translation>Nächstes Merkmal</translation>
    </message>
    <message>
        <source>Puts the finger on it. Key: Tab</source>
        <translation>Setzt den Finger darauf. Taste: Tab</translation>
    </message>
    <message>
        <source>Next face</source>
        <translation>Nächstes Gesicht</translation>
    </message>
    <message>
        <source>Fits one face after another into the touch surface. Key: F</source>
        <translation>Passt ein Gesicht nach dem anderen in die Tastfläche ein. Taste: F</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Führung</translation>
    </message>
    <message>
        <source>Strongest force</source>
        <translation>Maximale Kraft</translation>
    </message>
    <message>
        <source>%1 newtons</source>
        <translation>%1 Newton</translation>
    </message>
    <message>
        <source>Voice</source>
        <translation>Stimme</translation>
    </message>
    <message>
        <source>Open photograph…</source>
        <translation>Foto öffnen…</translation>
    </message>
    <message>
        <source>Key: O</source>
        <translation>Taste: O</translation>
    </message>
    <message>
        <source>Device: %1</source>
        <translation>Gerät: %1</translation>
    </message>
    <message>
        <source>Next photograph</source>
        <translation>Nächstes Foto</translation>
    </message>
    <message>
        <source>The next one in the album with a face. Key: N</source>
        <translation>Das nächste im Album mit einem Gesicht. Taste: N</translation>
    </message>
    <message>
        <source>Previous photograph</source>
        <translation>Vorheriges Foto</translation>
    </message>
    <message>
        <source>Key: Shift+N</source>
        <translation>Tasten: Umschalt+N</translation>
    </message>
    <message>
        <source>Ticks: %1</source>
        <translation>Ticks: %1</translation>
    </message>
    <message>
        <source>Ticks on</source>
        <translation>Ticks einschalten</translation>
    </message>
</context>
<context>
    <name>SoundsDialog</name>
    <message>
        <source>Add sound files</source>
        <translation>Tondateien hinzufügen</translation>
    </message>
    <message>
        <source>Sounds (%1)</source>
        <translation>Töne (%1)</translation>
    </message>
    <message>
        <source>All files (%1)</source>
        <translation>Alle Dateien (%1)</translation>
    </message>
</context>
<context>
    <name>StartPage</name>
    <message>
        <source>Press the number of an answer, or the answer itself. 0 or Backspace: previous question. R: repeat the question.</source>
        <translation>Drücken Sie die Nummer einer Antwort oder die Antwort selbst. 0 oder Rücktaste: vorherige Frage. R: die Frage noch einmal hören.</translation>
    </message>
    <message>
        <source>Press the number of what you want to do, or go through the buttons with Tab. R: repeat this page.</source>
        <translation>Drücken Sie die Nummer dessen, was Sie tun möchten, oder gehen Sie mit Tab durch die Schaltflächen. R: diese Seite noch einmal hören.</translation>
    </message>
    <message>
        <source>Question %1 of %2</source>
        <translation>Frage %1 von %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Noch einmal hören</translation>
    </message>
    <message>
        <source>Key: R</source>
        <translation>Taste: R</translation>
    </message>
    <message>
        <source>Previous question</source>
        <translation>Vorherige Frage</translation>
    </message>
    <message>
        <source>Key: 0</source>
        <translation>Taste: 0</translation>
    </message>
</context>
<context>
    <name>StudyPage</name>
    <message>
        <source>Space starts and ends a trial, and goes on after a break. A number key gives an answer. Arrow keys move the hand by 2 millimetres, with Shift by 10, where no device does. P pauses, W says where you are. Escape stops; the force is then off at once.</source>
        <translation>Die Leertaste beginnt und beendet einen Durchgang und führt nach einer Pause weiter. Eine Zifferntaste gibt eine Antwort. Wo kein Gerät den Finger bewegt, bewegen die Pfeiltasten die Hand um 2 Millimeter, mit Umschalt um 10. P macht eine Pause, W sagt, wo Sie sind. Escape hält an; die Kraft ist dann sofort aus.</translation>
    </message>
    <message>
        <source>Keys 1 to 9: experiment. O: an experiment&apos;s file. F: the study&apos;s folder. G: the folder with faces. N, Minus and Plus: participant. M: what moves the finger. L: consent to the force that the study needs. S: start. C: how the study stands. R: makes its report. W: says where you are.</source>
        <translation>Tasten 1 bis 9: Experiment. O: Datei eines Experiments. F: Ordner der Studie. G: Ordner mit Gesichtern. N, Minus und Plus: Versuchsperson. M: was den Finger bewegt. L: in die Kraft einwilligen, die die Studie braucht. S: beginnen. C: Stand der Studie. R: erstellt ihren Bericht. W: sagt, wo Sie sind.</translation>
    </message>
</context>
<context>
    <name>StudySurface</name>
    <message>
        <source>Study surface</source>
        <translation>Tastfläche der Studie</translation>
    </message>
</context>
<context>
    <name>StudyWords</name>
    <message>
        <source>Following contours, by stiffness and range</source>
        <translation>Konturen folgen, nach Steifigkeit und Reichweite</translation>
    </message>
    <message>
        <source>Naming shapes of three sizes</source>
        <translation>Formen in drei Größen benennen</translation>
    </message>
    <message>
        <source>Naming the expressions of faces</source>
        <translation>Gesichtsausdrücke benennen</translation>
    </message>
    <message>
        <source>Following contours by the exact and the published law</source>
        <translation>Konturen folgen, mit dem exakten und dem veröffentlichten Führungsgesetz</translation>
    </message>
    <message>
        <source>Naming expressions by the exact and the published law</source>
        <translation>Gesichtsausdrücke benennen, mit dem exakten und dem veröffentlichten Führungsgesetz</translation>
    </message>
    <message>
        <source>Follow a line with your finger from its start to its end, as exactly and as fast as you can; a closed line once round. The trial ends by itself at the end of the line. If you think that you are there and nothing happens, press Space.</source>
        <translation>Folgen Sie einer Linie mit dem Finger von ihrem Anfang bis zu ihrem Ende, so genau und so schnell Sie können; einer geschlossenen Linie einmal herum. Am Ende der Linie endet der Durchgang von selbst. Wenn Sie meinen, dort zu sein, und nichts geschieht, drücken Sie die Leertaste.</translation>
    </message>
    <message>
        <source>Feel a face until you know how it looks. Then press Space, and the number of your answer.</source>
        <translation>Ertasten Sie ein Gesicht, bis Sie wissen, wie es aussieht. Drücken Sie dann die Leertaste und die Ziffer Ihrer Antwort.</translation>
    </message>
    <message>
        <source>Feel a shape until you know which it is. Then press Space, and the number of your answer.</source>
        <translation>Ertasten Sie eine Form, bis Sie wissen, welche es ist. Drücken Sie dann die Leertaste und die Ziffer Ihrer Antwort.</translation>
    </message>
    <message>
        <source>Participant %1</source>
        <translation>Versuchsperson %1</translation>
    </message>
    <message>
        <source>%1 has done all %2 trials.</source>
        <translation>%1 hat alle %2 Durchgänge abgeschlossen.</translation>
    </message>
    <message>
        <source>%1 has done %2 of %3 trials.</source>
        <translation>%1 hat %2 von %3 Durchgängen abgeschlossen.</translation>
    </message>
    <message>
        <source>Training %1 of %2</source>
        <translation>Übung %1 von %2</translation>
    </message>
    <message>
        <source>Trial %1 of %2</source>
        <translation>Durchgang %1 von %2</translation>
    </message>
    <message>
        <source>%1, once more</source>
        <translation>%1, noch einmal</translation>
    </message>
    <message>
        <source>Feel the shape.</source>
        <translation>Ertasten Sie die Form.</translation>
    </message>
    <message>
        <source>Follow the line.</source>
        <translation>Folgen Sie der Linie.</translation>
    </message>
    <message>
        <source>Feel the face.</source>
        <translation>Ertasten Sie das Gesicht.</translation>
    </message>
    <message>
        <source>%1. %2 Press Space to start.</source>
        <translation>%1. %2 Die Leertaste beginnt.</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>Dreieck</translation>
    </message>
    <message>
        <source>square</source>
        <translation>Quadrat</translation>
    </message>
    <message>
        <source>pentagon</source>
        <translation>Fünfeck</translation>
    </message>
    <message>
        <source>hexagon</source>
        <translation>Sechseck</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>smiling</source>
        <translation>lächelnd</translation>
    </message>
    <message>
        <source>surprised</source>
        <translation>überrascht</translation>
    </message>
    <message>
        <source>sad</source>
        <translation>traurig</translation>
    </message>
    <message>
        <source>angry</source>
        <translation>wütend</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>How did the face look?</source>
        <translation>Wie sah das Gesicht aus?</translation>
    </message>
    <message>
        <source>Which was it?</source>
        <translation>Welche Form war es?</translation>
    </message>
    <message>
        <source>The time is over. %1</source>
        <translation>Die Zeit ist um. %1</translation>
    </message>
    <message>
        <source>You are asked to take part in a study: %1. It has %3 trials. What is kept is the way of your finger, the force on it, times and answers, on this computer only, under the number %2 and without your name. You may pause at any time with P and stop with Escape, without giving a reason; the force is then off at once. Nothing has been kept so far. If you agree, press Enter. If you do not, press Escape.</source>
        <translation>Sie werden gebeten, an einer Studie teilzunehmen: %1. Sie hat %3 Durchgänge. Gespeichert werden der Weg Ihres Fingers, die Kraft auf ihn, Zeiten und Antworten, nur auf diesem Computer, unter der Nummer %2 und ohne Ihren Namen. Sie können jederzeit mit P eine Pause machen und mit Escape aufhören, ohne einen Grund zu nennen; die Kraft ist dann sofort aus. Bisher ist nichts gespeichert. Wenn Sie einverstanden sind, drücken Sie die Eingabetaste. Wenn nicht, drücken Sie Escape.</translation>
    </message>
    <message>
        <source>Participants: %1.</source>
        <translation>Versuchspersonen: %1.</translation>
    </message>
    <message>
        <source>Trials that count: %1.</source>
        <translation>Gültige Durchgänge: %1.</translation>
    </message>
    <message>
        <source>Trials done again: %1.</source>
        <translation>Wiederholte Durchgänge: %1.</translation>
    </message>
    <message>
        <source>Mean tracking error: %1 millimetres.</source>
        <translation>Mittlerer Abstand vom Weg: %1 Millimeter.</translation>
    </message>
    <message>
        <source>Named rightly: %1 percent.</source>
        <translation>Richtig benannt: %1 Prozent.</translation>
    </message>
    <message>
        <source>Mean time: %1 seconds.</source>
        <translation>Mittlere Zeit: %1 Sekunden.</translation>
    </message>
    <message>
        <source>Feel the line; nothing is asked.</source>
        <translation>Ertasten Sie die Linie; es wird nichts gefragt.</translation>
    </message>
    <message>
        <source>The pull is cut at %1 newtons; the study asks for %2.</source>
        <translation>Der Zug ist auf %1 Newton begrenzt; die Studie verlangt %2.</translation>
    </message>
    <message>
        <source>The force may be stronger than this program usually allows, up to %1 newtons.</source>
        <translation>Die Kraft kann stärker sein, als dieses Programm sonst zulässt, bis zu %1 Newton.</translation>
    </message>
</context>
<context>
    <name>SurfaceView</name>
    <message>
        <source>Touch surface</source>
        <translation>Tastfläche</translation>
    </message>
    <message>
        <source>Move a finger to hear what is under it. Arrow keys move the hand, Tab goes from feature to feature, Space starts the guided tour, Z zooms in.</source>
        <translation>Bewegen Sie einen Finger, um zu hören, was darunter ist. Die Pfeiltasten bewegen die Hand, Tab geht von Merkmal zu Merkmal, die Leertaste startet den geführten Rundgang, Z vergrößert.</translation>
    </message>
    <message>
        <source>No photograph yet. Press O, or drop one here.</source>
        <translation>Noch kein Foto. Drücken Sie O oder ziehen Sie eines hierher.</translation>
    </message>
</context>
<context>
    <name>TactileNotes</name>
    <message numerus="yes">
        <source>%n character(s) of the name %1 have no braille and are left out.</source>
        <translation>
            <numerusform>%n Zeichen des Namens %1 gibt es nicht in Punktschrift; es wird weggelassen.</numerusform>
            <numerusform>%n Zeichen des Namens %1 gibt es nicht in Punktschrift; sie werden weggelassen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The name %1 is cut off after %n line(s) of braille.</source>
        <translation>
            <numerusform>Der Name %1 wird nach %n Punktschriftzeile abgeschnitten.</numerusform>
            <numerusform>Der Name %1 wird nach %n Punktschriftzeilen abgeschnitten.</numerusform>
        </translation>
    </message>
    <message>
        <source>The %1 is drawn as one line, because its two sides would be too close to be told apart.</source>
        <translation>Als eine einzige Linie gezeichnet: %1. Die beiden Seiten lägen zu dicht beieinander, um sie zu unterscheiden.</translation>
    </message>
    <message>
        <source>The %1 is drawn in part, because the rest would be less than 3 mm from another line.</source>
        <translation>Nur zum Teil gezeichnet: %1. Der Rest wäre weniger als 3 mm von einer anderen Linie entfernt.</translation>
    </message>
    <message>
        <source>The %1 is left out, because it would be too small or less than 3 mm from another line.</source>
        <translation>Weggelassen: %1. Das Merkmal wäre zu klein oder weniger als 3 mm von einer anderen Linie entfernt.</translation>
    </message>
    <message>
        <source>The name %1 is left out, because there is no room for its braille.</source>
        <translation>Der Name %1 wird weggelassen, weil für seine Punktschrift kein Platz ist.</translation>
    </message>
</context>
<context>
    <name>TakePart</name>
    <message>
        <source>What to record</source>
        <translation>Was aufgenommen wird</translation>
    </message>
    <message>
        <source>Finish the recording</source>
        <translation>Aufnahme beenden</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Discard…</source>
        <translation>Verwerfen…</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Yes, discard it</source>
        <translation>Ja, verwerfen</translation>
    </message>
    <message>
        <source>Add a sound file…</source>
        <translation>Tondatei hinzufügen…</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Loudness</source>
        <translation>Lautstärke</translation>
    </message>
</context>
<context>
    <name>TpButton</name>
    <message>
        <source>%1, not available</source>
        <translation>%1, nicht verfügbar</translation>
    </message>
</context>
<context>
    <name>TpChoice</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>TpListRow</name>
    <message>
        <source>%1, %2 of %3</source>
        <translation>%1, %2 von %3</translation>
    </message>
</context>
<context>
    <name>TrimPart</name>
    <message>
        <source>Start of the part to keep</source>
        <translation>Anfang des Teils, der bleibt</translation>
    </message>
    <message>
        <source>End of the part to keep</source>
        <translation>Ende des Teils, der bleibt</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Play the part to keep</source>
        <translation>Anhören, was bleibt</translation>
    </message>
    <message>
        <source>Trim to this part</source>
        <translation>Auf diesen Teil kürzen</translation>
    </message>
    <message>
        <source>The rest can be brought back with Undo.</source>
        <translation>„Rückgängig“ kann den Rest zurückbringen.</translation>
    </message>
    <message>
        <source>Keep all of it</source>
        <translation>Alles behalten</translation>
    </message>
</context>
<context>
    <name>UndoBar</name>
    <message>
        <source>Undo: %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Key: Control+Z</source>
        <translation>Tasten: Strg+Z</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Wiederholen: %1</translation>
    </message>
    <message>
        <source>Key: Control+Shift+Z</source>
        <translation>Tasten: Strg+Umschalt+Z</translation>
    </message>
</context>
<context>
    <name>WordsPane</name>
    <message>
        <source>Photograph</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Detail</translation>
    </message>
</context>
<context>
    <name>tp::BrowseAlbum</name>
    <message>
        <source>There is no album yet. Choose the folders of your photographs on the settings page, or import photographs.</source>
        <translation>Es gibt noch kein Album. Wählen Sie auf der Seite „Einstellungen“ die Ordner Ihrer Fotos aus oder importieren Sie Fotos.</translation>
    </message>
    <message>
        <source>Looking for photographs in your folders.</source>
        <translation>Fotos werden in Ihren Ordnern gesucht.</translation>
    </message>
    <message>
        <source>There are no photographs in your folders yet. Import some, or choose other folders on the settings page.</source>
        <translation>In Ihren Ordnern sind noch keine Fotos. Importieren Sie welche oder wählen Sie auf der Seite „Einstellungen“ andere Ordner aus.</translation>
    </message>
    <message>
        <source>Looking for what is new in your folders</source>
        <translation>Neues wird in Ihren Ordnern gesucht</translation>
    </message>
    <message>
        <source>Reading new photographs, %1 of %2</source>
        <translation>Neue Fotos werden gelesen, %1 von %2</translation>
    </message>
    <message>
        <source>%1, about %2 left</source>
        <comment>progress, and a time</comment>
        <translation>%1, noch etwa %2</translation>
    </message>
</context>
<context>
    <name>tp::BrowseDetails</name>
    <message>
        <source>%1 is no longer in this list. Now: %2</source>
        <translation>%1 ist nicht mehr in dieser Liste. Jetzt: %2</translation>
    </message>
</context>
<context>
    <name>tp::BrowseLists</name>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Years</source>
        <translation>Jahre</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Orte</translation>
    </message>
    <message>
        <source>Keywords</source>
        <translation>Stichwörter</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suche</translation>
    </message>
    <message>
        <source>There are no photographs of that any more.</source>
        <translation>Davon gibt es keine Fotos mehr.</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <comment>list, place in it, summary</comment>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>These are all the photographs; there is no list above them.</source>
        <translation>Das sind alle Fotos; darüber gibt es keine Liste.</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s)</source>
        <translation>
            <numerusform>%n Foto</numerusform>
            <numerusform>%n Fotos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n year(s)</source>
        <translation>
            <numerusform>%n Jahr</numerusform>
            <numerusform>%n Jahre</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n person(s)</source>
        <translation>
            <numerusform>%n Person</numerusform>
            <numerusform>%n Personen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n place(s)</source>
        <translation>
            <numerusform>%n Ort</numerusform>
            <numerusform>%n Orte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n keyword(s)</source>
        <translation>
            <numerusform>%n Stichwort</numerusform>
            <numerusform>%n Stichwörter</numerusform>
        </translation>
    </message>
    <message>
        <source>The first %1</source>
        <comment>of a long list</comment>
        <translation>Die ersten %1</translation>
    </message>
    <message>
        <source>Show more</source>
        <translation>Mehr zeigen</translation>
    </message>
    <message>
        <source>person, %1</source>
        <translation>Person, %1</translation>
    </message>
    <message>
        <source>place, %1</source>
        <translation>Ort, %1</translation>
    </message>
    <message>
        <source>keyword, %1</source>
        <translation>Stichwort, %1</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s) or more</source>
        <translation>
            <numerusform>%n Foto oder mehr</numerusform>
            <numerusform>%n Fotos oder mehr</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>two counts</comment>
        <translation>%1, %2</translation>
    </message>
    <message numerus="yes">
        <source>%n suggestion(s)</source>
        <translation>
            <numerusform>%n Vorschlag</numerusform>
            <numerusform>%n Vorschläge</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>a row and what belongs to it</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Go to a row first.</source>
        <translation>Gehen Sie zuerst zu einer Zeile.</translation>
    </message>
    <message>
        <source>Found: %1</source>
        <comment>a search</comment>
        <translation>Gefunden: %1</translation>
    </message>
    <message>
        <source>%1.</source>
        <comment>what was found</comment>
        <translation>%1.</translation>
    </message>
    <message>
        <source>There is no letter to delete.</source>
        <translation>Es gibt keinen Buchstaben zum Löschen.</translation>
    </message>
    <message>
        <source>The search field is empty.</source>
        <translation>Das Suchfeld ist leer.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <comment>what is typed, what was found</comment>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>Search. Type a name, a place or a word, or move a finger over the letters and lift it on one. The arrow keys go through what is found.</source>
        <translation>Suche. Geben Sie einen Namen, einen Ort oder ein Wort ein, oder fahren Sie mit einem Finger über die Buchstaben und heben ihn auf einem ab. Die Pfeiltasten gehen durch das Gefundene.</translation>
    </message>
    <message>
        <source>Search for %1: %2.</source>
        <translation>Suche nach %1: %2.</translation>
    </message>
    <message>
        <source>%1: there are none yet.</source>
        <comment>a list</comment>
        <translation>%1: noch keine.</translation>
    </message>
    <message>
        <source>%1: %2. Choose one with the arrow keys and Enter.</source>
        <comment>a list, how many</comment>
        <translation>%1: %2. Wählen Sie mit den Pfeiltasten und der Eingabetaste.</translation>
    </message>
</context>
<context>
    <name>tp::BrowsePlayback</name>
    <message>
        <source>This photograph has no recordings yet.</source>
        <translation>Dieses Foto hat noch keine Aufnahmen.</translation>
    </message>
    <message>
        <source>%1, %2 of %3</source>
        <comment>a recording, and times in it</comment>
        <translation>%1, %2 von %3</translation>
    </message>
    <message>
        <source>Speed %1</source>
        <comment>of recordings</comment>
        <translation>Tempo %1</translation>
    </message>
</context>
<context>
    <name>tp::BrowseSession</name>
    <message>
        <source>%1, %2: %3</source>
        <comment>list, place in it, summary</comment>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>Swipe or use the arrow keys to move on; double tap or press Enter to listen.</source>
        <translation>Wischen Sie oder drücken Sie die Pfeiltasten, um weiterzugehen; zum Anhören tippen Sie doppelt oder drücken Sie die Eingabetaste.</translation>
    </message>
    <message>
        <source>Swipe or use the arrow keys to move on.</source>
        <translation>Wischen Sie oder drücken Sie die Pfeiltasten, um weiterzugehen.</translation>
    </message>
    <message>
        <source>Your photographs, %1: %2 %3</source>
        <comment>place, summary, what can be done</comment>
        <translation>Ihre Fotos, %1: %2 %3</translation>
    </message>
    <message>
        <source>%1 Paused: %2, at %3.</source>
        <comment>where one is; the recording and the time in it</comment>
        <translation>%1 Angehalten: %2, bei %3.</translation>
    </message>
    <message>
        <source>Left and right: previous and next photograph. Up and down: its details. Enter: play the recordings, or pause. Escape: stop. Plus and minus: faster and slower. Home and End: first and last photograph. S: search. P: people. Y: years. L: places. K: keywords. R: surprise me. A: all photographs. Backspace: back. E: feel the face. C: look after this photograph. W: where am I. H: these keys. A swipe does what its arrow key does, a double tap plays, a two-finger tap stops, a Z drawn with two fingers goes back, a three-finger tap says where you are.</source>
        <translation>Links und rechts: vorheriges und nächstes Foto. Auf und ab: seine Details. Eingabetaste: Aufnahmen abspielen oder anhalten. Escape: anhalten. Plus und Minus: schneller und langsamer. Pos1 und Ende: erstes und letztes Foto. S: Suche. P: Personen. Y: Jahre. L: Orte. K: Stichwörter. R: ein zufälliges Foto. A: alle Fotos. Rücktaste: zurück. E: das Gesicht fühlen. C: dieses Foto pflegen. W: wo bin ich. H: diese Tasten. Wischen wirkt wie die Pfeiltaste in dieser Richtung, Doppeltippen spielt ab, Tippen mit zwei Fingern hält an, ein Z mit zwei Fingern geht zurück, Tippen mit drei Fingern sagt, wo Sie sind.</translation>
    </message>
    <message>
        <source>Your photographs.</source>
        <translation>Ihre Fotos.</translation>
    </message>
</context>
<context>
    <name>tp::BrowseTrail</name>
    <message>
        <source>All photographs</source>
        <translation>Alle Fotos</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>a place in a list</comment>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>This is the last photograph.</source>
        <translation>Das ist das letzte Foto.</translation>
    </message>
    <message>
        <source>This is the first photograph.</source>
        <translation>Das ist das erste Foto.</translation>
    </message>
</context>
<context>
    <name>tp::CaptureCamera</name>
    <message>
        <source>The camera has stopped.</source>
        <translation>Die Kamera liefert kein Bild mehr.</translation>
    </message>
</context>
<context>
    <name>tp::CaptureChoices</name>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>The photograph is taken automatically when all is well.</source>
        <translation>Das Foto wird automatisch aufgenommen, wenn alles stimmt.</translation>
    </message>
    <message>
        <source>The photograph is taken when you press Space or touch the screen.</source>
        <translation>Das Foto wird aufgenommen, wenn Sie die Leertaste drücken oder den Bildschirm berühren.</translation>
    </message>
    <message>
        <source>The microphone is on. The sound from five seconds before a photograph to five seconds after it is kept with it.</source>
        <translation>Das Mikrofon ist an. Zu jedem Foto wird der Klang von fünf Sekunden davor bis fünf Sekunden danach gespeichert.</translation>
    </message>
    <message>
        <source>The microphone is off. Photographs are kept without sound.</source>
        <translation>Das Mikrofon ist aus. Fotos werden ohne Klang gespeichert.</translation>
    </message>
</context>
<context>
    <name>tp::CaptureMemo</name>
    <message>
        <source>The recorder is still busy. Try again in a moment.</source>
        <translation>Die Aufnahme ist noch nicht abgeschlossen. Versuchen Sie es gleich noch einmal.</translation>
    </message>
    <message>
        <source>%1 Saved.</source>
        <translation>%1 Gespeichert.</translation>
    </message>
</context>
<context>
    <name>tp::CaptureSession</name>
    <message>
        <source>Press I to import photographs of another camera.</source>
        <translation>Drücken Sie I, um Fotos einer anderen Kamera zu importieren.</translation>
    </message>
    <message>
        <source>Take a photograph. %1.</source>
        <translation>Foto aufnehmen. %1.</translation>
    </message>
    <message>
        <source>Take a photograph. Point the camera at somebody, and listen where to move it. When all is well, the photograph is taken automatically; press S if you do not want that. Space takes it at once.</source>
        <translation>Foto aufnehmen. Richten Sie die Kamera auf jemanden und hören Sie, wohin sie soll. Wenn alles stimmt, wird das Foto automatisch aufgenommen; drücken Sie S, wenn Sie das nicht möchten. Die Leertaste nimmt es sofort auf.</translation>
    </message>
    <message>
        <source>The camera is starting.</source>
        <translation>Die Kamera startet.</translation>
    </message>
    <message>
        <source>There is only one camera.</source>
        <translation>Es gibt nur eine Kamera.</translation>
    </message>
    <message>
        <source>Front camera.</source>
        <translation>Frontkamera.</translation>
    </message>
    <message>
        <source>Back camera.</source>
        <translation>Rückkamera.</translation>
    </message>
    <message>
        <source>This camera has no light.</source>
        <translation>Diese Kamera hat kein Licht.</translation>
    </message>
    <message>
        <source>Light on.</source>
        <translation>Licht an.</translation>
    </message>
    <message>
        <source>Light off.</source>
        <translation>Licht aus.</translation>
    </message>
    <message>
        <source>Take a photograph first; then you can record a memo for it.</source>
        <translation>Nehmen Sie zuerst ein Foto auf; dann können Sie ein Memo dazu aufnehmen.</translation>
    </message>
    <message>
        <source>The microphone is on.</source>
        <translation>Das Mikrofon ist an.</translation>
    </message>
</context>
<context>
    <name>tp::CaptureShutter</name>
    <message>
        <source>There is nothing to look through.</source>
        <translation>Es gibt nichts durchzugehen.</translation>
    </message>
    <message>
        <source>Frame %1 of %2: %3.</source>
        <translation>Bild %1 von %2: %3.</translation>
    </message>
    <message>
        <source>This one is kept too.</source>
        <translation>Auch dieses ist gespeichert.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Es gibt nichts rückgängig zu machen.</translation>
    </message>
    <message>
        <source>Undone: %1.</source>
        <translation>Rückgängig gemacht: %1.</translation>
    </message>
</context>
<context>
    <name>tp::CaptureTouch</name>
    <message>
        <source>There is no motor here that could tick. The tone and words lead you.</source>
        <translation>Hier ist kein Motor, der ticken könnte. Der Ton und Worte führen Sie.</translation>
    </message>
    <message>
        <source>Ticks again: %1.</source>
        <translation>Wieder Ticks: %1.</translation>
    </message>
    <message>
        <source>%1 Until then the tone and words lead you.</source>
        <translation>%1 Bis dahin führen Sie der Ton und Worte.</translation>
    </message>
    <message>
        <source>No more ticks from %1: until it is there again the tone and words lead you.</source>
        <translation>Keine Ticks mehr von %1: bis es wieder da ist, führen Sie der Ton und Worte.</translation>
    </message>
</context>
<context>
    <name>tp::CareFolders</name>
    <message>
        <source>No folder was chosen.</source>
        <translation>Es wurde kein Ordner ausgewählt.</translation>
    </message>
</context>
<context>
    <name>tp::CareHistory</name>
    <message>
        <source>Undone: %1.</source>
        <translation>Rückgängig gemacht: %1.</translation>
    </message>
    <message>
        <source>Redone: %1.</source>
        <translation>Wiederholt: %1.</translation>
    </message>
    <message>
        <source>Deleted: %1. Undo brings it back.</source>
        <translation>Gelöscht: %1. „Rückgängig“ bringt es zurück.</translation>
    </message>
</context>
<context>
    <name>tp::CareSession</name>
    <message>
        <source>Look after the album. It has no folder yet. Import photographs, and choose where to keep them.</source>
        <translation>Album pflegen. Es hat noch keinen Ordner. Importieren Sie Fotos und wählen Sie, wo sie aufbewahrt werden.</translation>
    </message>
    <message>
        <source>Look after the album. %1 is open: its faces, recordings and description.</source>
        <translation>Album pflegen. %1 ist geöffnet: Gesichter, Aufnahmen und Beschreibung.</translation>
    </message>
    <message>
        <source>Look after the album. %1 Choose one, or import more.</source>
        <translation>Album pflegen. %1 Wählen Sie eines aus oder importieren Sie weitere.</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s).</source>
        <translation>
            <numerusform>%n Foto.</numerusform>
            <numerusform>%n Fotos.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::DescriptionCare</name>
    <message>
        <source>The description is saved.</source>
        <translation>Die Beschreibung ist gespeichert.</translation>
    </message>
</context>
<context>
    <name>tp::DeviceSettings</name>
    <message>
        <source>%1, over USB (HID)</source>
        <translation>%1, über USB (HID)</translation>
    </message>
    <message>
        <source>%1, over USB (bulk)</source>
        <translation>%1, über USB (Bulk)</translation>
    </message>
    <message>
        <source>None: sound, and a drawn finger</source>
        <translation>Keines: Ton und ein gezeichneter Finger</translation>
    </message>
    <message>
        <source>%1, not plugged in</source>
        <translation>%1, nicht angeschlossen</translation>
    </message>
    <message>
        <source>Calibrated: misses by %1 millimetres on average.</source>
        <translation>Kalibriert: liegt im Mittel %1 Millimeter daneben.</translation>
    </message>
    <message>
        <source>Not calibrated. It may stand beside the screen; to lie on it, it must be calibrated.</source>
        <translation>Nicht kalibriert. Es darf neben dem Bildschirm stehen; um darauf zu liegen, muss es kalibriert werden.</translation>
    </message>
    <message>
        <source>No force device is plugged in. Plug one in; it is found automatically.</source>
        <translation>Kein Kraftgerät ist angeschlossen. Schließen Sie eines an; es wird automatisch gefunden.</translation>
    </message>
    <message>
        <source>No force device is chosen. Choose one above.</source>
        <translation>Kein Kraftgerät ist ausgewählt. Wählen Sie oben eines aus.</translation>
    </message>
    <message>
        <source>The strongest force, %1 newtons: to the right, then to the left. Escape ends it.</source>
        <translation>Die maximale Kraft, %1 Newton: nach rechts, dann nach links. Escape beendet es.</translation>
    </message>
    <message>
        <source>Calibration. The device lies on the screen; put a finger into it, so that it touches the screen. Escape ends it. %1</source>
        <translation>Kalibrierung. Das Gerät liegt auf dem Bildschirm; stecken Sie einen Finger hinein, sodass er den Bildschirm berührt. Escape beendet sie. %1</translation>
    </message>
    <message>
        <source>That was the strongest force.</source>
        <translation>Das war die maximale Kraft.</translation>
    </message>
    <message>
        <source>Touch the top left corner and keep still until I speak.</source>
        <translation>Berühren Sie die Ecke oben links und halten Sie still, bis ich spreche.</translation>
    </message>
    <message>
        <source>Now the top right corner.</source>
        <translation>Nun die Ecke oben rechts.</translation>
    </message>
    <message>
        <source>Now the bottom right corner.</source>
        <translation>Nun die Ecke unten rechts.</translation>
    </message>
    <message>
        <source>Now the bottom left corner.</source>
        <translation>Nun die Ecke unten links.</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The calibration misses your touches by %1 millimetres on average, and at most %2 are allowed. Make sure that the device does not slip on the screen, keep still at each corner, and calibrate again.</source>
        <translation>Die Kalibrierung liegt im Mittel %1 Millimeter neben Ihren Berührungen, erlaubt sind höchstens %2. Achten Sie darauf, dass das Gerät nicht auf dem Bildschirm rutscht, halten Sie an jeder Ecke still und kalibrieren Sie noch einmal.</translation>
    </message>
    <message>
        <source>The device and the screen do not move alike. Calibrate again with the finger in the device, and no other on the screen.</source>
        <translation>Gerät und Bildschirm bewegen sich nicht gleich. Kalibrieren Sie noch einmal mit dem Finger im Gerät und keinem anderen auf dem Bildschirm.</translation>
    </message>
    <message>
        <source>Calibrated. It misses by %1 millimetres on average, and is saved for this device.</source>
        <translation>Kalibriert. Im Mittel liegt es %1 Millimeter daneben; das ist für dieses Gerät gespeichert.</translation>
    </message>
    <message>
        <source>Calibration cancelled. Nothing was changed.</source>
        <translation>Kalibrierung abgebrochen. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Stopped. The force is off.</source>
        <translation>Angehalten. Die Kraft ist aus.</translation>
    </message>
    <message>
        <source>The device is homed: it knows where its handle is.</source>
        <translation>Der Nullpunkt ist gesetzt: Das Gerät weiß jetzt, wo sein Griff ist.</translation>
    </message>
    <message>
        <source>This device knows its own force; only force sticks need measuring.</source>
        <translation>Dieses Gerät kennt seine Kraft selbst; nur Kraftsticks müssen gemessen werden.</translation>
    </message>
    <message>
        <source>%1 Escape ends it.</source>
        <translation>%1 Escape beendet es.</translation>
    </message>
    <message>
        <source>That is too little to be read well. The stick pulls twice as strongly now: weigh again.</source>
        <translation>Das ist zu wenig, um es gut abzulesen. Der Kraftstick zieht jetzt doppelt so stark: Wiegen Sie noch einmal.</translation>
    </message>
    <message>
        <source>The stick is measured: %1 newtons at most. That is saved for this stick.</source>
        <translation>Der Kraftstick ist gemessen: höchstens %1 Newton. Das ist für diesen Stick gespeichert.</translation>
    </message>
    <message>
        <source>Measurement cancelled. The force is off. Nothing was changed.</source>
        <translation>Messung abgebrochen. Die Kraft ist aus. Nichts wurde geändert.</translation>
    </message>
</context>
<context>
    <name>tp::ExploreChoices</name>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Beeps</source>
        <translation>Pieptöne</translation>
    </message>
    <message>
        <source>Clock directions</source>
        <translation>Uhrzeitansage</translation>
    </message>
    <message>
        <source>Beeps and clock directions</source>
        <translation>Pieptöne und Uhrzeitansage</translation>
    </message>
    <message>
        <source>Guide: %1.</source>
        <translation>Führung: %1.</translation>
    </message>
    <message>
        <source>Ticks under the finger</source>
        <translation>Ticks unter dem Finger</translation>
    </message>
    <message>
        <source>Ticks and beeps</source>
        <translation>Ticks und Pieptöne</translation>
    </message>
</context>
<context>
    <name>tp::ExploreDevice</name>
    <message>
        <source>The force is on.</source>
        <translation>Die Kraft ist an.</translation>
    </message>
    <message>
        <source>The device is ready. Its force is on.</source>
        <translation>Das Gerät ist bereit. Seine Kraft ist an.</translation>
    </message>
    <message>
        <source>The device is ready. Its force is off. Press Enter to switch it on.</source>
        <translation>Das Gerät ist bereit. Seine Kraft ist aus. Die Eingabetaste schaltet sie ein.</translation>
    </message>
    <message>
        <source>The picture is too small or too large on the screen to be felt where it is seen. The device feels it in its true size.</source>
        <translation>Das Bild ist auf dem Bildschirm zu klein oder zu groß, um dort gefühlt zu werden, wo es zu sehen ist. Das Gerät fühlt es in seiner wahren Größe.</translation>
    </message>
    <message>
        <source>Device: %1. Its force is on.</source>
        <translation>Gerät: %1. Seine Kraft ist an.</translation>
    </message>
    <message>
        <source>Device: %1. Its force is off. Press Enter to switch it on.</source>
        <translation>Gerät: %1. Seine Kraft ist aus. Die Eingabetaste schaltet sie ein.</translation>
    </message>
    <message>
        <source>%1 Until then the force is only drawn.</source>
        <translation>%1 Bis dahin wird die Kraft nur gezeichnet.</translation>
    </message>
    <message>
        <source>Ticks are on.</source>
        <translation>Die Ticks sind an.</translation>
    </message>
</context>
<context>
    <name>tp::ExploreEar</name>
    <message numerus="yes">
        <source>%1 o&apos;clock, %n millimetre(s)</source>
        <translation>
            <numerusform>%1 Uhr, %n Millimeter</numerusform>
            <numerusform>%1 Uhr, %n Millimeter</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::ExploreFinger</name>
    <message>
        <source>There is nothing to feel here.</source>
        <translation>Hier gibt es nichts zu fühlen.</translation>
    </message>
</context>
<context>
    <name>tp::ExploreHand</name>
    <message>
        <source>Move the finger with the device.</source>
        <translation>Bewegen Sie den Finger mit dem Gerät.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 o&apos;clock, %n millimetre(s).</source>
        <translation>
            <numerusform>%1: %2 Uhr, %n Millimeter.</numerusform>
            <numerusform>%1: %2 Uhr, %n Millimeter.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::ExploreSession</name>
    <message>
        <source>Explore. %1 Move a finger over the picture; W says where it is.</source>
        <translation>Erkunden. %1 Bewegen Sie einen Finger über das Bild; W sagt, wo er ist.</translation>
    </message>
    <message>
        <source>Explore. %1</source>
        <translation>Erkunden. %1</translation>
    </message>
    <message>
        <source>Only a photograph that is a file on this computer can be opened.</source>
        <translation>Nur ein Foto, das als Datei auf diesem Computer liegt, kann geöffnet werden.</translation>
    </message>
    <message>
        <source>Stopped. The force is off. Press Enter to switch it on.</source>
        <translation>Angehalten. Die Kraft ist aus. Die Eingabetaste schaltet sie ein.</translation>
    </message>
    <message>
        <source>Stopped. Ticks are off. Press Enter to switch them on.</source>
        <translation>Angehalten. Die Ticks sind aus. Die Eingabetaste schaltet sie ein.</translation>
    </message>
</context>
<context>
    <name>tp::ExploreTouch</name>
    <message>
        <source>There is nothing here that ticks under a finger. Beeps and words guide.</source>
        <translation>Hier ist nichts, was unter einem Finger ticken kann. Pieptöne und Worte führen.</translation>
    </message>
    <message>
        <source>Ticks: %1.</source>
        <translation>Ticks: %1.</translation>
    </message>
    <message>
        <source>Ticks: %1. They are off. Press Enter to switch them on.</source>
        <translation>Ticks: %1. Sie sind aus. Die Eingabetaste schaltet sie ein.</translation>
    </message>
    <message>
        <source>%1 Until then beeps and words guide.</source>
        <translation>%1 Bis dahin führen Pieptöne und Worte.</translation>
    </message>
    <message>
        <source>%1 is gone. Beeps and words guide until it is there again.</source>
        <translation>%1 ist nicht mehr da. Pieptöne und Worte führen, bis es wieder da ist.</translation>
    </message>
    <message>
        <source>%1 is gone. Until it is there again, ticks come from: %2.</source>
        <translation>%1 ist nicht mehr da. Bis es wieder da ist, kommen die Ticks von: %2.</translation>
    </message>
</context>
<context>
    <name>tp::ExploreTour</name>
    <message>
        <source>The force is off. Press Enter to switch it on.</source>
        <translation>Die Kraft ist aus. Die Eingabetaste schaltet sie ein.</translation>
    </message>
    <message>
        <source>Tour round the %1.</source>
        <translation>Rundgang: %1.</translation>
    </message>
    <message numerus="yes">
        <source>Tour of %1: %n feature(s). %2.</source>
        <translation>
            <numerusform>Rundgang: %1, %n Merkmal. %2.</numerusform>
            <numerusform>Rundgang: %1, %n Merkmale. %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Tour finished.</source>
        <translation>Rundgang zu Ende.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>Tour ended.</source>
        <translation>Rundgang beendet.</translation>
    </message>
    <message>
        <source>Ticks are off. Press Enter to switch them on.</source>
        <translation>Die Ticks sind aus. Die Eingabetaste schaltet sie ein.</translation>
    </message>
    <message>
        <source>Tour round the %1. Follow the ticks: they grow toward the line.</source>
        <translation>Rundgang: %1. Folgen Sie den Ticks: Zur Linie hin werden sie stärker.</translation>
    </message>
</context>
<context>
    <name>tp::ExploreView</name>
    <message>
        <source>the face</source>
        <translation>das Gesicht</translation>
    </message>
    <message>
        <source>face %1</source>
        <translation>Gesicht %1</translation>
    </message>
    <message>
        <source>There is no photograph yet. Press O, or the button Open photograph, to choose one.</source>
        <translation>Noch ist kein Foto da. Drücken Sie O oder die Schaltfläche „Foto öffnen“, um eines auszuwählen.</translation>
    </message>
    <message>
        <source>Looking for faces…</source>
        <translation>Gesichter werden gesucht…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Search stopped. Press O to open a photograph.</source>
        <translation>Suche abgebrochen. Drücken Sie O, um ein Foto zu öffnen.</translation>
    </message>
    <message>
        <source>Search stopped. %1 is open again. The force is off. Press Enter to switch it on.</source>
        <translation>Suche abgebrochen. %1 ist wieder geöffnet. Die Kraft ist aus. Die Eingabetaste schaltet sie ein.</translation>
    </message>
    <message>
        <source>Search stopped. %1 is open again.</source>
        <translation>Suche abgebrochen. %1 ist wieder geöffnet.</translation>
    </message>
    <message>
        <source>face</source>
        <translation>Gesicht</translation>
    </message>
</context>
<context>
    <name>tp::ExploreWalk</name>
    <message>
        <source>Your newest photograph with a face.</source>
        <translation>Ihr neuestes Foto mit einem Gesicht.</translation>
    </message>
    <message numerus="yes">
        <source>Skipped %n photograph(s) without a face.</source>
        <translation>
            <numerusform>%n Foto ohne Gesicht übersprungen.</numerusform>
            <numerusform>%n Fotos ohne Gesicht übersprungen.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1.</source>
        <comment>a photograph&apos;s name</comment>
        <translation>%1.</translation>
    </message>
    <message numerus="yes">
        <source>Still looking: %n photograph(s) without a face so far.</source>
        <translation>
            <numerusform>Es wird weitergesucht: bisher %n Foto ohne Gesicht.</numerusform>
            <numerusform>Es wird weitergesucht: bisher %n Fotos ohne Gesicht.</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no face on any photograph in the album.</source>
        <translation>Auf keinem Foto des Albums ist ein Gesicht.</translation>
    </message>
    <message>
        <source>No photograph with a face comes after this one.</source>
        <translation>Danach kommt kein Foto mit einem Gesicht mehr.</translation>
    </message>
    <message>
        <source>No photograph with a face comes before this one.</source>
        <translation>Davor gibt es kein Foto mit einem Gesicht.</translation>
    </message>
</context>
<context>
    <name>tp::ExploreZoom</name>
    <message>
        <source>Zoomed out to the whole face.</source>
        <translation>Verkleinert: das ganze Gesicht.</translation>
    </message>
    <message numerus="yes">
        <source>Zoomed out to all %n face(s).</source>
        <translation>
            <numerusform>Verkleinert: %n Gesicht.</numerusform>
            <numerusform>Verkleinert: alle %n Gesichter.</numerusform>
        </translation>
    </message>
    <message>
        <source>Zoomed to the eyes of %1.</source>
        <translation>Vergrößert: die Augen von %1.</translation>
    </message>
    <message>
        <source>Zoomed to the eyes.</source>
        <translation>Vergrößert: die Augen.</translation>
    </message>
    <message>
        <source>Zoomed to the left eye of %1.</source>
        <translation>Vergrößert: das linke Auge von %1.</translation>
    </message>
    <message>
        <source>Zoomed to the left eye.</source>
        <translation>Vergrößert: das linke Auge.</translation>
    </message>
    <message>
        <source>Zoomed to the right eye of %1.</source>
        <translation>Vergrößert: das rechte Auge von %1.</translation>
    </message>
    <message>
        <source>Zoomed to the right eye.</source>
        <translation>Vergrößert: das rechte Auge.</translation>
    </message>
    <message>
        <source>Zoomed to the mouth of %1.</source>
        <translation>Vergrößert: der Mund von %1.</translation>
    </message>
    <message>
        <source>Zoomed to the mouth.</source>
        <translation>Vergrößert: der Mund.</translation>
    </message>
    <message>
        <source>Zoomed to %1.</source>
        <translation>Vergrößert: %1.</translation>
    </message>
    <message>
        <source>This part is too small in the picture to zoom to it.</source>
        <translation>Dieser Teil ist im Bild zu klein, um ihn zu vergrößern.</translation>
    </message>
    <message>
        <source>%1 %2.</source>
        <translation>%1 %2.</translation>
    </message>
    <message>
        <source>This is the whole picture.</source>
        <translation>Das ist das ganze Bild.</translation>
    </message>
    <message>
        <source>There is nothing more to zoom in to here.</source>
        <translation>Hier lässt sich nichts weiter vergrößern.</translation>
    </message>
</context>
<context>
    <name>tp::ExtractionWords</name>
    <message>
        <source>One face.</source>
        <translation>Ein Gesicht.</translation>
    </message>
    <message>
        <source>Two faces.</source>
        <translation>Zwei Gesichter.</translation>
    </message>
    <message>
        <source>Three faces.</source>
        <translation>Drei Gesichter.</translation>
    </message>
    <message>
        <source>Four faces.</source>
        <translation>Vier Gesichter.</translation>
    </message>
    <message numerus="yes">
        <source>%n face(s).</source>
        <translation>
            <numerusform>%n Gesicht.</numerusform>
            <numerusform>%n Gesichter.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <comment>the end of a list</comment>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>eyes</source>
        <translation>Augen</translation>
    </message>
    <message>
        <source>mouth</source>
        <translation>Mund</translation>
    </message>
    <message>
        <source>outline</source>
        <translation>Gesichtsumriss</translation>
    </message>
    <message>
        <source>brows</source>
        <translation>Augenbrauen</translation>
    </message>
    <message>
        <source>nose</source>
        <translation>Nase</translation>
    </message>
    <message>
        <source>irises</source>
        <translation>Iris</translation>
    </message>
    <message>
        <source>%1.</source>
        <comment>who is on the picture</comment>
        <translation>%1.</translation>
    </message>
    <message>
        <source>%1 can be felt.</source>
        <translation>Zu fühlen: %1.</translation>
    </message>
    <message>
        <source>%1 of each can be felt.</source>
        <translation>Bei jedem zu fühlen: %1.</translation>
    </message>
</context>
<context>
    <name>tp::FaceCare</name>
    <message>
        <source>Face without a name</source>
        <translation>Gesicht ohne Namen</translation>
    </message>
    <message>
        <source>Looking for faces…</source>
        <translation>Gesichter werden gesucht…</translation>
    </message>
    <message>
        <source>No face was found on this photograph.</source>
        <translation>Auf diesem Foto wurde kein Gesicht gefunden.</translation>
    </message>
    <message numerus="yes">
        <source>%n face(s)</source>
        <translation>
            <numerusform>%n Gesicht</numerusform>
            <numerusform>%n Gesichter</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, all with a name.</source>
        <translation>%1, alle mit Namen.</translation>
    </message>
    <message>
        <source>%1, %2.</source>
        <translation>%1, %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n without a name</source>
        <translation>
            <numerusform>%n ohne Namen</numerusform>
            <numerusform>%n ohne Namen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2 of %3. Type a name or choose one below.</source>
        <translation>%1, %2 von %3. Tippen Sie einen Namen oder wählen Sie unten einen aus.</translation>
    </message>
    <message>
        <source>This face has no name now.</source>
        <translation>Dieses Gesicht hat jetzt keinen Namen.</translation>
    </message>
    <message>
        <source>Saved: %1.</source>
        <translation>Gespeichert: %1.</translation>
    </message>
    <message>
        <source>%1 Who is the next face?</source>
        <translation>%1 Wer ist das nächste Gesicht?</translation>
    </message>
    <message>
        <source>Saved: %1 is read in the page&apos;s language.</source>
        <translation>Gespeichert: %1 wird in der Sprache der Seite gelesen.</translation>
    </message>
    <message>
        <source>Saved: %1. Language of the name: %2.</source>
        <translation>Gespeichert: %1. Sprache des Namens: %2.</translation>
    </message>
    <message>
        <source>One face, with a name.</source>
        <translation>Ein Gesicht, mit Namen.</translation>
    </message>
    <message>
        <source>One face, without a name.</source>
        <translation>Ein Gesicht, ohne Namen.</translation>
    </message>
    <message>
        <source>Perhaps %1</source>
        <translation>Vielleicht %1</translation>
    </message>
    <message>
        <source>%1 %2?</source>
        <translation>%1 %2?</translation>
    </message>
</context>
<context>
    <name>tp::FeatureLabels</name>
    <message>
        <source>left eye</source>
        <translation>linkes Auge</translation>
    </message>
    <message>
        <source>right eye</source>
        <translation>rechtes Auge</translation>
    </message>
    <message>
        <source>lips</source>
        <translation>Lippen</translation>
    </message>
    <message>
        <source>mouth opening</source>
        <translation>Mundöffnung</translation>
    </message>
    <message>
        <source>face outline</source>
        <translation>Gesichtsumriss</translation>
    </message>
    <message>
        <source>left brow</source>
        <translation>linke Augenbraue</translation>
    </message>
    <message>
        <source>right brow</source>
        <translation>rechte Augenbraue</translation>
    </message>
    <message>
        <source>nose</source>
        <translation>Nase</translation>
    </message>
    <message>
        <source>left iris</source>
        <translation>linke Iris</translation>
    </message>
    <message>
        <source>right iris</source>
        <translation>rechte Iris</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>left eye of Anna</comment>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 of face %2</source>
        <comment>left eye of face 2</comment>
        <translation>%1 von Gesicht %2</translation>
    </message>
</context>
<context>
    <name>tp::FeelingSettings</name>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Beeps</source>
        <translation>Pieptöne</translation>
    </message>
    <message>
        <source>Clock directions</source>
        <translation>Uhrzeitansage</translation>
    </message>
    <message>
        <source>Beeps and clock directions</source>
        <translation>Pieptöne und Uhrzeitansage</translation>
    </message>
    <message>
        <source>the guide</source>
        <translation>die Führung</translation>
    </message>
    <message>
        <source>the strongest force</source>
        <translation>die maximale Kraft</translation>
    </message>
    <message>
        <source>At most %1 newtons.</source>
        <translation>Höchstens %1 Newton.</translation>
    </message>
    <message>
        <source>the force device</source>
        <translation>das Kraftgerät</translation>
    </message>
    <message>
        <source>Force device: %1.</source>
        <translation>Kraftgerät: %1.</translation>
    </message>
    <message>
        <source>brows</source>
        <translation>Augenbrauen</translation>
    </message>
    <message>
        <source>Brows are felt.</source>
        <translation>Augenbrauen sind zu fühlen.</translation>
    </message>
    <message>
        <source>Brows are not felt.</source>
        <translation>Augenbrauen sind nicht zu fühlen.</translation>
    </message>
    <message>
        <source>the nose</source>
        <translation>die Nase</translation>
    </message>
    <message>
        <source>The nose is felt.</source>
        <translation>Die Nase ist zu fühlen.</translation>
    </message>
    <message>
        <source>The nose is not felt.</source>
        <translation>Die Nase ist nicht zu fühlen.</translation>
    </message>
    <message>
        <source>irises</source>
        <translation>Iris</translation>
    </message>
    <message>
        <source>Irises are felt.</source>
        <translation>Die Iris ist zu fühlen.</translation>
    </message>
    <message>
        <source>Irises are not felt.</source>
        <translation>Die Iris ist nicht zu fühlen.</translation>
    </message>
    <message>
        <source>Ticks under the finger</source>
        <translation>Ticks unter dem Finger</translation>
    </message>
    <message>
        <source>Ticks and beeps</source>
        <translation>Ticks und Pieptöne</translation>
    </message>
</context>
<context>
    <name>tp::FocusText</name>
    <message>
        <source>button</source>
        <translation>Schaltfläche</translation>
    </message>
    <message>
        <source>switch</source>
        <translation>Schalter</translation>
    </message>
    <message>
        <source>choice</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>slider</source>
        <translation>Schieberegler</translation>
    </message>
    <message>
        <source>text field</source>
        <translation>Textfeld</translation>
    </message>
    <message>
        <source>on</source>
        <translation>an</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>selected</source>
        <translation>ausgewählt</translation>
    </message>
</context>
<context>
    <name>tp::FolderChooser</name>
    <message>
        <source>no photographs in this folder itself</source>
        <translation>keine Fotos direkt in diesem Ordner</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s) in this folder itself</source>
        <translation>
            <numerusform>%n Foto direkt in diesem Ordner</numerusform>
            <numerusform>%n Fotos direkt in diesem Ordner</numerusform>
        </translation>
    </message>
    <message>
        <source>The folder %1 cannot be read.</source>
        <translation>Der Ordner %1 kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>the whole computer</source>
        <translation>der ganze Computer</translation>
    </message>
    <message>
        <source>no subfolders</source>
        <translation>keine Unterordner</translation>
    </message>
    <message numerus="yes">
        <source>%n subfolder(s)</source>
        <translation>
            <numerusform>%n Unterordner</numerusform>
            <numerusform>%n Unterordner</numerusform>
        </translation>
    </message>
    <message>
        <source>Folder %1: %2, %3.</source>
        <translation>Ordner %1: %2, %3.</translation>
    </message>
</context>
<context>
    <name>tp::GroupCare</name>
    <message>
        <source>Looking for people…</source>
        <translation>Personen werden gesucht…</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>%1 %2.</source>
        <translation>%1 %2.</translation>
    </message>
    <message>
        <source>%1. %2.</source>
        <translation>%1. %2.</translation>
    </message>
    <message>
        <source>Saved: %1, on %2.</source>
        <translation>Gespeichert: %1, auf %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s)</source>
        <translation>
            <numerusform>%n Foto</numerusform>
            <numerusform>%n Fotos</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 Who is the next? %2.</source>
        <translation>%1 Wer ist die nächste Person? %2.</translation>
    </message>
    <message>
        <source>%1 Nobody is left without a name.</source>
        <translation>%1 Alle haben jetzt einen Namen.</translation>
    </message>
    <message>
        <source>This face is somebody else&apos;s.</source>
        <translation>Dieses Gesicht gehört jemand anderem.</translation>
    </message>
    <message>
        <source>This face is not that of %1.</source>
        <translation>Dieses Gesicht ist nicht das von %1.</translation>
    </message>
    <message>
        <source>Selected: %1.</source>
        <translation>Ausgewählt: %1.</translation>
    </message>
</context>
<context>
    <name>tp::ImportCare</name>
    <message>
        <source>From %1 into %2.</source>
        <translation>Aus %1 nach %2.</translation>
    </message>
    <message>
        <source>Looking for photographs…</source>
        <translation>Fotos werden gesucht…</translation>
    </message>
    <message>
        <source>An import is running. Wait until it ends, or stop it first.</source>
        <translation>Ein Import läuft gerade. Warten Sie sein Ende ab oder halten Sie ihn zuerst an.</translation>
    </message>
    <message>
        <source>Only photographs and folders on this computer can be imported.</source>
        <translation>Nur Fotos und Ordner auf diesem Computer können importiert werden.</translation>
    </message>
    <message>
        <source>Choose the folder to keep the album in. The photographs are copied into it.</source>
        <translation>Wählen Sie den Ordner, in dem das Album liegen soll. Die Fotos werden dorthin kopiert.</translation>
    </message>
    <message>
        <source>Importing…</source>
        <translation>Import läuft…</translation>
    </message>
    <message>
        <source>The album needs a folder on this computer.</source>
        <translation>Das Album braucht einen Ordner auf diesem Computer.</translation>
    </message>
    <message>
        <source>The folder %1 now belongs to the album.</source>
        <translation>Der Ordner %1 gehört jetzt zum Album.</translation>
    </message>
    <message>
        <source>Stopping after this photograph.</source>
        <translation>Nach diesem Foto wird angehalten.</translation>
    </message>
    <message>
        <source>The import continues.</source>
        <translation>Der Import wird fortgesetzt.</translation>
    </message>
    <message>
        <source>The import is discarded. What was imported stays.</source>
        <translation>Der Import ist verworfen. Was schon importiert ist, bleibt.</translation>
    </message>
</context>
<context>
    <name>tp::KeeperSteps</name>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Es gibt nichts rückgängig zu machen.</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>Es gibt nichts zu wiederholen.</translation>
    </message>
</context>
<context>
    <name>tp::LabActivity</name>
    <message>
        <source>Nothing can be changed during a recording. Escape ends it.</source>
        <translation>Während einer Aufnahme kann nichts geändert werden. Escape beendet sie.</translation>
    </message>
    <message>
        <source>Nothing can be changed during a replay. Escape ends it.</source>
        <translation>Während einer Wiedergabe kann nichts geändert werden. Escape beendet sie.</translation>
    </message>
</context>
<context>
    <name>tp::LabArchive</name>
    <message>
        <source>The folder %1 cannot be created: %2</source>
        <translation>Der Ordner %1 kann nicht angelegt werden: %2</translation>
    </message>
    <message>
        <source>The recording cannot be started: %1</source>
        <translation>Die Aufnahme kann nicht begonnen werden: %1</translation>
    </message>
    <message>
        <source>The recording is not whole, because the disk is full or this computer was too busy.</source>
        <translation>Die Aufnahme ist nicht vollständig, weil der Datenträger voll ist oder dieser Computer zu beschäftigt war.</translation>
    </message>
    <message>
        <source>Recorded in %1; the parameters lie beside it.</source>
        <translation>Aufgenommen in %1; die Parameter liegen daneben.</translation>
    </message>
    <message>
        <source>There is nothing to save yet. Start the servo first.</source>
        <translation>Es gibt noch nichts zu speichern. Starten Sie zuerst den Servo.</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) are in %1; the parameters lie beside them.</source>
        <translation>
            <numerusform>%n Zeile ist in %1; die Parameter liegen daneben.</numerusform>
            <numerusform>%n Zeilen sind in %1; die Parameter liegen daneben.</numerusform>
        </translation>
    </message>
    <message>
        <source>The table cannot be written: %1</source>
        <translation>Die Tabelle kann nicht geschrieben werden: %1</translation>
    </message>
</context>
<context>
    <name>tp::LabDevices</name>
    <message>
        <source>Simulated: the mouse or a finger on the screen</source>
        <translation>Simuliert: die Maus oder ein Finger auf dem Bildschirm</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>tp::LabHand</name>
    <message>
        <source>The finger is %1. </source>
        <translation>Der Finger ist %1. </translation>
    </message>
    <message>
        <source>No line pulls there.</source>
        <translation>Dort zieht keine Linie.</translation>
    </message>
    <message>
        <source>%1 mm from %2; the law pulls with %3 newtons.</source>
        <translation>%1 mm von %2; das Führungsgesetz zieht mit %3 Newton.</translation>
    </message>
</context>
<context>
    <name>tp::LabReplayer</name>
    <message>
        <source>Reading %1.</source>
        <translation>%1 wird gelesen.</translation>
    </message>
    <message>
        <source>%1 is empty.</source>
        <translation>%1 ist leer.</translation>
    </message>
    <message>
        <source>Replaying %1. Escape ends it.</source>
        <translation>%1 wird wiedergegeben. Escape beendet die Wiedergabe.</translation>
    </message>
    <message>
        <source>The replay has ended. %1</source>
        <translation>Die Wiedergabe ist zu Ende. %1</translation>
    </message>
</context>
<context>
    <name>tp::LabRun</name>
    <message>
        <source>Opening %1.</source>
        <translation>%1 wird geöffnet.</translation>
    </message>
    <message>
        <source>Recording: %1. Escape ends it.</source>
        <translation>Aufnahme läuft: %1. Escape beendet sie.</translation>
    </message>
    <message>
        <source>The servo is running: %1. Escape stops it.</source>
        <translation>Der Servo läuft: %1. Escape hält ihn an.</translation>
    </message>
    <message>
        <source>Only a simulated device that is running can be made to hang.</source>
        <translation>Hängen kann nur ein simuliertes Gerät, das läuft.</translation>
    </message>
    <message>
        <source>The device hangs for 200 milliseconds.</source>
        <translation>Das Gerät hängt 200 Millisekunden lang.</translation>
    </message>
</context>
<context>
    <name>tp::LabScene</name>
    <message>
        <source>Photograph</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>Photograph %1</source>
        <translation>Foto %1</translation>
    </message>
    <message>
        <source>Circle, radius 40 mm</source>
        <translation>Kreis, Radius 40 mm</translation>
    </message>
    <message>
        <source>Triangle, 50 mm high</source>
        <translation>Dreieck, 50 mm hoch</translation>
    </message>
    <message>
        <source>Curved path, 200 mm wide</source>
        <translation>Gebogener Pfad, 200 mm breit</translation>
    </message>
    <message>
        <source>Force field of %1: colours and arrows from 0 to %2 newtons. The scale bar is 20 mm long.</source>
        <translation>Kraftfeld, %1: Farben und Pfeile von 0 bis %2 Newton. Der Maßstab ist 20 mm lang.</translation>
    </message>
    <message>
        <source>Only a photograph that is a file on this computer can be opened.</source>
        <translation>Nur ein Foto, das als Datei auf diesem Computer liegt, kann geöffnet werden.</translation>
    </message>
    <message>
        <source>There is no photograph yet. Open one, or drop one on the page.</source>
        <translation>Noch ist kein Foto da. Öffnen Sie eines oder ziehen Sie eines auf die Seite.</translation>
    </message>
    <message>
        <source>Looking for faces in %1.</source>
        <translation>Gesichter werden in %1 gesucht.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n line(s) can be felt.</source>
        <translation>
            <numerusform>%1: %n Linie ist zu fühlen.</numerusform>
            <numerusform>%1: %n Linien sind zu fühlen.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::LabSession</name>
    <message>
        <source>The lab. A finger on a simulated device, a force field, and everything that can be adjusted. Space on the surface starts the servo, Escape stops it.</source>
        <translation>Das Labor. Ein Finger auf einem simulierten Gerät, ein Kraftfeld und alles, was sich einstellen lässt. Die Leertaste auf der Tastfläche startet den Servo, Escape hält ihn an.</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Angehalten.</translation>
    </message>
</context>
<context>
    <name>tp::LabTeller</name>
    <message>
        <source>Nothing is running.</source>
        <translation>Nichts läuft.</translation>
    </message>
</context>
<context>
    <name>tp::LabTuning</name>
    <message>
        <source>Exact</source>
        <translation>Exakt</translation>
    </message>
    <message>
        <source>Published Algorithm 1</source>
        <translation>Veröffentlichter Algorithmus 1</translation>
    </message>
    <message>
        <source>the law</source>
        <translation>das Führungsgesetz</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>%1: on.</source>
        <translation>%1: ein.</translation>
    </message>
    <message>
        <source>%1: off.</source>
        <translation>%1: aus.</translation>
    </message>
    <message>
        <source>the reset</source>
        <translation>das Zurücksetzen</translation>
    </message>
    <message>
        <source>Law, servo, device and faults are reset.</source>
        <translation>Führungsgesetz, Servo, Gerät und Fehler sind zurückgesetzt.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Es gibt nichts rückgängig zu machen.</translation>
    </message>
    <message>
        <source>Undone: %1.</source>
        <translation>Rückgängig gemacht: %1.</translation>
    </message>
</context>
<context>
    <name>tp::LookSettings</name>
    <message>
        <source>Somebody who listens and feels</source>
        <translation>Jemand, der zuhört und fühlt</translation>
    </message>
    <message>
        <source>Somebody who looks after the album</source>
        <translation>Jemand, der das Album pflegt</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Yellow on black</source>
        <translation>Gelb auf Schwarz</translation>
    </message>
    <message>
        <source>who uses the tablet</source>
        <translation>wer das Tablet benutzt</translation>
    </message>
    <message>
        <source>the colours</source>
        <translation>die Farben</translation>
    </message>
    <message>
        <source>the text size</source>
        <translation>die Textgröße</translation>
    </message>
    <message>
        <source>Text size: %1 percent.</source>
        <translation>Textgröße: %1 Prozent.</translation>
    </message>
    <message>
        <source>animations</source>
        <translation>Animationen</translation>
    </message>
    <message>
        <source>Animations on.</source>
        <translation>Animationen an.</translation>
    </message>
    <message>
        <source>Animations off.</source>
        <translation>Animationen aus.</translation>
    </message>
</context>
<context>
    <name>tp::MendDrag</name>
    <message>
        <source>the %1 was moved</source>
        <translation>%1 verschoben</translation>
    </message>
    <message>
        <source>a point of the %1 was moved</source>
        <translation>Punkt verschoben, %1</translation>
    </message>
    <message>
        <source>%1 moved.</source>
        <translation>%1 verschoben.</translation>
    </message>
    <message>
        <source>Put back.</source>
        <translation>Wieder am alten Platz.</translation>
    </message>
</context>
<context>
    <name>tp::MendEditing</name>
    <message>
        <source>the %1 was moved</source>
        <translation>%1 verschoben</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>a point of the %1 was moved</source>
        <translation>Punkt verschoben, %1</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>No point is selected. Tab goes from point to point.</source>
        <translation>Kein Punkt ist ausgewählt. Tab geht von Punkt zu Punkt.</translation>
    </message>
    <message>
        <source>a point of the %1 was added</source>
        <translation>Punkt hinzugefügt, %1</translation>
    </message>
    <message>
        <source>Added. %1: %2.</source>
        <translation>Hinzugefügt. %1: %2.</translation>
    </message>
    <message>
        <source>The %1 needs its last points. The whole feature can be removed.</source>
        <translation>Das Merkmal braucht seine letzten Punkte: %1. Das ganze Merkmal kann entfernt werden.</translation>
    </message>
    <message>
        <source>a point of the %1 was deleted</source>
        <translation>Punkt gelöscht, %1</translation>
    </message>
    <message>
        <source>Deleted. Selected: %1.</source>
        <translation>Gelöscht. Ausgewählt: %1.</translation>
    </message>
    <message>
        <source>This point cannot be a corner.</source>
        <translation>Dieser Punkt kann keine Ecke sein.</translation>
    </message>
    <message>
        <source>a point of the %1 was converted</source>
        <translation>Punkt umgewandelt, %1</translation>
    </message>
    <message>
        <source>A corner now.</source>
        <translation>Jetzt eine Ecke.</translation>
    </message>
    <message>
        <source>Smooth now.</source>
        <translation>Jetzt glatt.</translation>
    </message>
    <message>
        <source>The %1 is as the program found it.</source>
        <translation>Schon so, wie das Programm es gefunden hat: %1.</translation>
    </message>
    <message>
        <source>the %1 was reset</source>
        <translation>%1 zurückgesetzt</translation>
    </message>
    <message>
        <source>The %1 is as the program found it again.</source>
        <translation>Wieder so, wie das Programm es gefunden hat: %1.</translation>
    </message>
    <message>
        <source>The %1 is gone again, because the program did not find it.</source>
        <translation>Wieder weg, weil das Programm es nicht gefunden hat: %1.</translation>
    </message>
    <message>
        <source>The %1 is there already.</source>
        <translation>Schon da: %1.</translation>
    </message>
    <message>
        <source>the %1 was added</source>
        <translation>%1 hinzugefügt</translation>
    </message>
    <message>
        <source>The %1 is there, as the program found it.</source>
        <translation>Wieder da, wie vom Programm gefunden: %1.</translation>
    </message>
    <message>
        <source>The %1 was added in its usual shape. Move it into place.</source>
        <translation>In üblicher Form hinzugefügt: %1. Rücken Sie das Merkmal zurecht.</translation>
    </message>
    <message>
        <source>the %1 was removed</source>
        <translation>%1 entfernt</translation>
    </message>
    <message>
        <source>The %1 was removed. It will not be felt.</source>
        <translation>Entfernt: %1. Das Merkmal ist dann nicht mehr zu fühlen.</translation>
    </message>
    <message>
        <source>a face was added</source>
        <translation>ein Gesicht hinzugefügt</translation>
    </message>
    <message>
        <source>A face of the usual shape was added. Move its features into place.</source>
        <translation>Ein Gesicht in üblicher Form wurde hinzugefügt. Rücken Sie seine Merkmale zurecht.</translation>
    </message>
</context>
<context>
    <name>tp::MendHistory</name>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Es gibt nichts rückgängig zu machen.</translation>
    </message>
    <message>
        <source>Undone: %1.</source>
        <translation>Rückgängig gemacht: %1.</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>Es gibt nichts zu wiederholen.</translation>
    </message>
    <message>
        <source>Redone: %1.</source>
        <translation>Wiederholt: %1.</translation>
    </message>
</context>
<context>
    <name>tp::MendPreview</name>
    <message>
        <source>The force is shown.</source>
        <translation>Die Kraft wird gezeigt.</translation>
    </message>
    <message>
        <source>The force is hidden.</source>
        <translation>Die Kraft ist ausgeblendet.</translation>
    </message>
</context>
<context>
    <name>tp::MendSaving</name>
    <message>
        <source>%1 Your work is kept here; nothing is lost.</source>
        <translation>%1 Ihre Arbeit bleibt hier erhalten; nichts geht verloren.</translation>
    </message>
    <message>
        <source>The contours are saved.</source>
        <translation>Die Konturen sind gespeichert.</translation>
    </message>
    <message>
        <source>The contours are saved. Another program had changed them; what it wrote is kept as %1.</source>
        <translation>Die Konturen sind gespeichert. Ein anderes Programm hatte sie geändert; seine Fassung ist als %1 aufbewahrt.</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>all changes were discarded</source>
        <translation>alle Änderungen verworfen</translation>
    </message>
    <message>
        <source>All changes are discarded: the contours are as they were when opened.</source>
        <translation>Alle Änderungen sind verworfen: Die Konturen sind wie beim Öffnen.</translation>
    </message>
</context>
<context>
    <name>tp::MendSelection</name>
    <message numerus="yes">
        <source>%1, %n point(s).</source>
        <translation>
            <numerusform>%1, %n Punkt.</numerusform>
            <numerusform>%1, %n Punkte.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: missing. It can be added.</source>
        <translation>%1: fehlt, kann aber hinzugefügt werden.</translation>
    </message>
    <message>
        <source>The whole feature moves.</source>
        <translation>Das ganze Merkmal wird verschoben.</translation>
    </message>
    <message>
        <source>One point moves.</source>
        <translation>Ein Punkt wird verschoben.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n point(s), none selected.</source>
        <translation>
            <numerusform>%1, %n Punkt, keiner ausgewählt.</numerusform>
            <numerusform>%1, %n Punkte, keiner ausgewählt.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of the %2: %3.</source>
        <translation>%1, %2: %3.</translation>
    </message>
</context>
<context>
    <name>tp::MendSession</name>
    <message>
        <source>Only a photograph that is a file on this computer can be opened.</source>
        <translation>Nur ein Foto, das als Datei auf diesem Computer liegt, kann geöffnet werden.</translation>
    </message>
    <message>
        <source>Looking for faces…</source>
        <translation>Gesichter werden gesucht…</translation>
    </message>
    <message>
        <source>This page mends the contours of a photograph. There is no photograph yet.</source>
        <translation>Auf dieser Seite werden die Konturen eines Fotos korrigiert. Noch ist kein Foto da.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a photograph and what is wrong with it</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No face was found in %1. You can add one of the usual shape and move it into place.</source>
        <translation>In %1 wurde kein Gesicht gefunden. Sie können eines in üblicher Form hinzufügen und zurechtrücken.</translation>
    </message>
    <message>
        <source>Contours of %1. Selected: %2. Tab goes from point to point, the arrow keys move it.</source>
        <translation>Konturen von %1. Ausgewählt: %2. Tab geht von Punkt zu Punkt, die Pfeiltasten verschieben ihn.</translation>
    </message>
</context>
<context>
    <name>tp::Narrator</name>
    <message>
        <source>Voice on.</source>
        <translation>Stimme an.</translation>
    </message>
    <message>
        <source>Voice off.</source>
        <translation>Stimme aus.</translation>
    </message>
    <message>
        <source>No speech engine was found on this computer, so TouchPhoto cannot speak. It tells a screen reader instead.</source>
        <translation>Auf diesem Computer wurde keine Sprachausgabe gefunden, deshalb kann TouchPhoto nicht sprechen. Stattdessen erhält ein Screenreader die Texte.</translation>
    </message>
</context>
<context>
    <name>tp::OpenAlbum</name>
    <message numerus="yes">
        <source>%n more thing(s) in the album need checking.</source>
        <translation>
            <numerusform>Im Album sollten Sie noch %n Sache prüfen.</numerusform>
            <numerusform>Im Album sollten Sie noch %n Sachen prüfen.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::PhotoRows</name>
    <message>
        <source>Not checked yet.</source>
        <translation>Noch nicht geprüft.</translation>
    </message>
    <message>
        <source>No face found.</source>
        <translation>Kein Gesicht gefunden.</translation>
    </message>
    <message>
        <source>Faces look wrong: %1 % off.</source>
        <translation>Gesichter sehen falsch aus: %1 % Abweichung.</translation>
    </message>
    <message>
        <source>Faces about %1 % off.</source>
        <translation>Gesichter mit etwa %1 % Abweichung.</translation>
    </message>
</context>
<context>
    <name>tp::PlaceWords</name>
    <message numerus="yes">
        <source>%1. On the %2, at its %3 o&apos;clock, %n millimetre(s) from its middle.</source>
        <translation>
            <numerusform>%1. Auf der Linie: %2, auf %3 Uhr, %n Millimeter von der Mitte.</numerusform>
            <numerusform>%1. Auf der Linie: %2, auf %3 Uhr, %n Millimeter von der Mitte.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Beside %1. %2 at %3 o&apos;clock, %n millimetre(s).</source>
        <translation>
            <numerusform>Daneben: %1. %2 auf %3 Uhr, %n Millimeter.</numerusform>
            <numerusform>Daneben: %1. %2 auf %3 Uhr, %n Millimeter.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1. %2 at %3 o&apos;clock, %n millimetre(s).</source>
        <translation>
            <numerusform>%1. %2 auf %3 Uhr, %n Millimeter.</numerusform>
            <numerusform>%1. %2 auf %3 Uhr, %n Millimeter.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::Player</name>
    <message>
        <source>The loudspeaker is gone. The recording goes on as soon as there is one again.</source>
        <translation>Der Lautsprecher ist weg. Die Aufnahme geht weiter, sobald wieder einer da ist.</translation>
    </message>
    <message>
        <source>There is no loudspeaker. The recording plays as soon as there is one.</source>
        <translation>Es ist kein Lautsprecher da. Die Aufnahme wird abgespielt, sobald einer da ist.</translation>
    </message>
</context>
<context>
    <name>tp::Preferences</name>
    <message>
        <source>Your settings could not be read. The default settings are used until that is put right.</source>
        <translation>Ihre Einstellungen konnten nicht gelesen werden. Bis das behoben ist, gelten die Standardeinstellungen.</translation>
    </message>
    <message>
        <source>Your settings could not be read and were set aside. The default settings are used; you can choose again on the settings page.</source>
        <translation>Ihre Einstellungen konnten nicht gelesen werden und wurden beiseitegelegt. Es gelten die Standardeinstellungen; auf der Seite „Einstellungen“ können Sie neu wählen.</translation>
    </message>
    <message>
        <source>Your settings could not be saved: %1</source>
        <translation>Ihre Einstellungen konnten nicht gespeichert werden: %1</translation>
    </message>
</context>
<context>
    <name>tp::PrintSession</name>
    <message>
        <source>Print. Choose a photograph on the page &quot;Look after the album&quot;.</source>
        <translation>Drucken. Wählen Sie ein Foto auf der Seite „Album pflegen“.</translation>
    </message>
    <message>
        <source>Print %1. Looking for faces…</source>
        <translation>Drucken: %1. Gesichter werden gesucht…</translation>
    </message>
    <message>
        <source>Print %1 on %2.</source>
        <translation>Drucken: %1 auf %2.</translation>
    </message>
    <message>
        <source>There is no sheet yet.</source>
        <translation>Es gibt noch kein Tastblatt.</translation>
    </message>
    <message>
        <source>The folder %1 could not be created: %2</source>
        <translation>Der Ordner %1 konnte nicht angelegt werden: %2</translation>
    </message>
    <message>
        <source>The sheet is saved as %1. Print it at 100 percent, unscaled.</source>
        <translation>Das Tastblatt ist als %1 gespeichert. Drucken Sie es mit 100 Prozent, nicht skaliert.</translation>
    </message>
    <message>
        <source>The sheet cannot be saved: %1</source>
        <translation>Das Blatt kann nicht gespeichert werden: %1</translation>
    </message>
</context>
<context>
    <name>tp::PrintedPhoto</name>
    <message>
        <source>The face</source>
        <translation>Das Gesicht</translation>
    </message>
    <message>
        <source>All faces</source>
        <translation>Alle Gesichter</translation>
    </message>
    <message>
        <source>Face %1</source>
        <translation>Gesicht %1</translation>
    </message>
</context>
<context>
    <name>tp::PrintedSheet</name>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Letter</translation>
    </message>
    <message>
        <source>A3</source>
        <translation>A3</translation>
    </message>
    <message>
        <source>Braille paper, 11 by 11.5 inches</source>
        <translation>Punktschriftpapier, 11 mal 11,5 Zoll</translation>
    </message>
    <message>
        <source>%1 by %2 millimetres</source>
        <translation>%1 mal %2 Millimeter</translation>
    </message>
    <message>
        <source>With the name in print.</source>
        <translation>Mit Namen in Schwarzschrift.</translation>
    </message>
    <message>
        <source>Without the name in print.</source>
        <translation>Ohne Namen in Schwarzschrift.</translation>
    </message>
</context>
<context>
    <name>tp::Program</name>
    <message>
        <source>TouchPhoto</source>
        <translation>TouchPhoto</translation>
    </message>
    <message>
        <source>Feel a face</source>
        <translation>Ein Gesicht fühlen</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Listen to photographs</source>
        <translation>Fotos anhören</translation>
    </message>
    <message>
        <source>Look after the album</source>
        <translation>Album pflegen</translation>
    </message>
    <message>
        <source>Mend contours</source>
        <translation>Konturen korrigieren</translation>
    </message>
    <message>
        <source>Print a tactile sheet</source>
        <translation>Tastblatt drucken</translation>
    </message>
    <message>
        <source>Lab</source>
        <translation>Labor</translation>
    </message>
    <message>
        <source>Take a photograph</source>
        <translation>Foto aufnehmen</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Studien</translation>
    </message>
    <message>
        <source>Still saving. TouchPhoto closes when everything is saved.</source>
        <translation>Es wird noch gespeichert. TouchPhoto schließt sich, wenn alles gespeichert ist.</translation>
    </message>
</context>
<context>
    <name>tp::Questions</name>
    <message>
        <source>Should TouchPhoto speak?</source>
        <translation>Soll TouchPhoto sprechen?</translation>
    </message>
    <message>
        <source>How fast should it speak?</source>
        <translation>Wie schnell soll es sprechen?</translation>
    </message>
    <message>
        <source>Who uses this tablet most?</source>
        <translation>Wer benutzt dieses Tablet am meisten?</translation>
    </message>
    <message>
        <source>Looking for a force device.</source>
        <translation>Ein Kraftgerät wird gesucht.</translation>
    </message>
    <message>
        <source>No force device was found. A finger on the screen is guided by sound instead.</source>
        <translation>Es wurde kein Kraftgerät gefunden. Ein Finger auf dem Bildschirm wird stattdessen durch Töne geführt.</translation>
    </message>
    <message>
        <source>A force device was found: %1.</source>
        <translation>Ein Kraftgerät wurde gefunden: %1.</translation>
    </message>
    <message>
        <source>Where are your photographs?</source>
        <translation>Wo sind Ihre Fotos?</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Ja</translation>
    </message>
    <message>
        <source>No, the words on the screen are enough</source>
        <translation>Nein, der Text auf dem Bildschirm genügt</translation>
    </message>
    <message>
        <source>No, my screen reader speaks</source>
        <translation>Nein, mein Screenreader spricht</translation>
    </message>
    <message>
        <source>Very slowly</source>
        <translation>Sehr langsam</translation>
    </message>
    <message>
        <source>Slowly</source>
        <translation>Langsam</translation>
    </message>
    <message>
        <source>At the usual speed</source>
        <translation>Normal schnell</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>Schnell</translation>
    </message>
    <message>
        <source>Very fast</source>
        <translation>Sehr schnell</translation>
    </message>
    <message>
        <source>Somebody who listens and feels</source>
        <translation>Jemand, der zuhört und fühlt</translation>
    </message>
    <message>
        <source>Somebody who looks after the album</source>
        <translation>Jemand, der das Album pflegt</translation>
    </message>
    <message>
        <source>Continue without a device</source>
        <translation>Ohne Gerät fortfahren</translation>
    </message>
    <message>
        <source>Use this device</source>
        <translation>Dieses Gerät benutzen</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>Noch einmal suchen</translation>
    </message>
    <message>
        <source>In the folder %1</source>
        <translation>Im Ordner %1</translation>
    </message>
    <message>
        <source>In another folder</source>
        <translation>In einem anderen Ordner</translation>
    </message>
    <message>
        <source>Ask me later</source>
        <translation>Später fragen</translation>
    </message>
    <message>
        <source>Question %1 of %2. %3</source>
        <translation>Frage %1 von %2. %3</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
</context>
<context>
    <name>tp::RecorderWorker</name>
    <message>
        <source>What was recorded is kept, and it goes on as soon as there is one.</source>
        <translation>Was aufgenommen wurde, bleibt erhalten, und es geht weiter, sobald wieder eines da ist.</translation>
    </message>
    <message>
        <source>The recording begins as soon as there is one.</source>
        <translation>Die Aufnahme beginnt, sobald eines da ist.</translation>
    </message>
    <message>
        <source>The microphone delivers no sound.</source>
        <translation>Das Mikrofon liefert keinen Ton.</translation>
    </message>
    <message>
        <source>This microphone cannot record 48000 samples a second; another one is needed.</source>
        <translation>Dieses Mikrofon kann keine 48000 Abtastwerte in der Sekunde aufnehmen; es wird ein anderes gebraucht.</translation>
    </message>
    <message>
        <source>The microphone is gone.</source>
        <translation>Das Mikrofon ist weg.</translation>
    </message>
    <message>
        <source>There is no microphone.</source>
        <translation>Es ist kein Mikrofon da.</translation>
    </message>
    <message>
        <source>There is not enough room on the disk for a recording.</source>
        <translation>Auf dem Datenträger ist nicht genug Platz für eine Aufnahme.</translation>
    </message>
    <message>
        <source>The recording cannot be made: %1</source>
        <translation>Die Aufnahme ist nicht möglich: %1</translation>
    </message>
    <message>
        <source>The microphone is there again. The recording goes on.</source>
        <translation>Das Mikrofon ist wieder da. Die Aufnahme geht weiter.</translation>
    </message>
    <message>
        <source>The recording begins.</source>
        <translation>Die Aufnahme beginnt.</translation>
    </message>
    <message>
        <source>The recording has ended, because %1</source>
        <translation>Die Aufnahme wurde beendet: %1</translation>
    </message>
    <message>
        <source>The microphone picks up nothing. It may be switched off or covered.</source>
        <translation>Das Mikrofon nimmt nichts auf. Vielleicht ist es ausgeschaltet oder verdeckt.</translation>
    </message>
    <message>
        <source>The disk is almost full, so the recording has ended.</source>
        <translation>Der Datenträger ist fast voll, deshalb wurde die Aufnahme beendet.</translation>
    </message>
    <message>
        <source>A recording lasts %1 at most, so it has ended.</source>
        <translation>Eine Aufnahme dauert höchstens %1, deshalb wurde sie beendet.</translation>
    </message>
    <message>
        <source>The disk is almost full: %1 can still be recorded.</source>
        <translation>Der Datenträger ist fast voll: %1 können noch aufgenommen werden.</translation>
    </message>
    <message>
        <source>%1 can still be recorded.</source>
        <translation>%1 können noch aufgenommen werden.</translation>
    </message>
    <message>
        <source>What was recorded is kept as &quot;%1&quot; and will be saved later, because %2</source>
        <translation>Was aufgenommen wurde, ist als „%1“ aufbewahrt und wird später gespeichert: %2</translation>
    </message>
    <message>
        <source>Nothing was recorded.</source>
        <translation>Es wurde nichts aufgenommen.</translation>
    </message>
    <message>
        <source>Recorded: %1.</source>
        <translation>Aufgenommen: %1.</translation>
    </message>
</context>
<context>
    <name>tp::RecordingList</name>
    <message>
        <source>Not given</source>
        <translation>Keine Angabe</translation>
    </message>
    <message>
        <source>%1, %2, %3 of %4</source>
        <translation>%1, %2, %3 von %4</translation>
    </message>
    <message>
        <source>This is the first one.</source>
        <translation>Das ist die erste.</translation>
    </message>
    <message>
        <source>This is the last one.</source>
        <translation>Das ist die letzte.</translation>
    </message>
    <message>
        <source>%1 is now number %2 of %3.</source>
        <translation>%1 ist jetzt Nummer %2 von %3.</translation>
    </message>
    <message>
        <source>Deleted: %1. Undo brings it back.</source>
        <translation>Gelöscht: %1. „Rückgängig“ bringt die Aufnahme zurück.</translation>
    </message>
    <message>
        <source>Saved: %1.</source>
        <translation>Gespeichert: %1.</translation>
    </message>
    <message>
        <source>Only a sound that is a file on this computer can be added.</source>
        <translation>Nur Töne, die als Datei auf diesem Computer liegen, können hinzugefügt werden.</translation>
    </message>
    <message>
        <source>Added: %1, %2. %3</source>
        <translation>Hinzugefügt: %1, %2. %3</translation>
    </message>
</context>
<context>
    <name>tp::RecordingWait</name>
    <message>
        <source>A recording is being made. Finish it first.</source>
        <translation>Es wird gerade aufgenommen. Beenden Sie erst die Aufnahme.</translation>
    </message>
</context>
<context>
    <name>tp::SettingSteps</name>
    <message>
        <source>the reset</source>
        <translation>das Zurücksetzen</translation>
    </message>
    <message>
        <source>All settings are reset. The album&apos;s folders stay.</source>
        <translation>Alle Einstellungen sind zurückgesetzt. Die Ordner des Albums bleiben.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Es gibt nichts rückgängig zu machen.</translation>
    </message>
    <message>
        <source>Undone: %1.</source>
        <translation>Rückgängig gemacht: %1.</translation>
    </message>
</context>
<context>
    <name>tp::SettingsSession</name>
    <message>
        <source>Settings. Go through them with Tab; every change is saved at once. Control+Z undoes the last one.</source>
        <translation>Einstellungen. Gehen Sie mit Tab hindurch; jede Änderung wird sofort gespeichert. Strg+Z macht die letzte rückgängig.</translation>
    </message>
</context>
<context>
    <name>tp::Shell</name>
    <message>
        <source>On every page: Escape stops whatever sounds or moves, then leads home. F1: this help. F2: repeat the last sentence. F3: voice on or off. Alt+Left: previous page.</source>
        <translation>Auf jeder Seite: Escape hält an, was klingt oder sich bewegt, und führt dann zur Startseite. F1: diese Hilfe. F2: den letzten Satz wiederholen. F3: Stimme ein oder aus. Alt+Pfeil links: vorherige Seite.</translation>
    </message>
</context>
<context>
    <name>tp::SpeechSettings</name>
    <message>
        <source>TouchPhoto speaks</source>
        <translation>TouchPhoto spricht</translation>
    </message>
    <message>
        <source>My screen reader speaks</source>
        <translation>Mein Screenreader spricht</translation>
    </message>
    <message>
        <source>Nobody speaks</source>
        <translation>Niemand spricht</translation>
    </message>
    <message>
        <source>Very slow</source>
        <translation>Sehr langsam</translation>
    </message>
    <message>
        <source>Slow</source>
        <translation>Langsam</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>Schnell</translation>
    </message>
    <message>
        <source>Very fast</source>
        <translation>Sehr schnell</translation>
    </message>
    <message>
        <source>Same as the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>who speaks</source>
        <translation>wer spricht</translation>
    </message>
    <message>
        <source>the speed of speech</source>
        <translation>das Sprechtempo</translation>
    </message>
    <message>
        <source>%1. This is how fast I speak.</source>
        <translation>%1. So schnell spreche ich.</translation>
    </message>
    <message>
        <source>the language</source>
        <translation>die Sprache</translation>
    </message>
    <message>
        <source>the speed of recordings</source>
        <translation>das Tempo der Aufnahmen</translation>
    </message>
    <message>
        <source>Recordings play at %1 times normal speed.</source>
        <translation>Aufnahmen laufen mit %1-facher Geschwindigkeit.</translation>
    </message>
    <message>
        <source>sound effects</source>
        <translation>Signaltöne</translation>
    </message>
    <message>
        <source>Sound effects on.</source>
        <translation>Signaltöne an.</translation>
    </message>
    <message>
        <source>Sound effects off.</source>
        <translation>Signaltöne aus.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Short</source>
        <translation>Kurz</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>Ausführlich</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Time and place</source>
        <translation>Zeit und Ort</translation>
    </message>
    <message>
        <source>Only what people wrote about a photograph is said.</source>
        <translation>Von einem Foto wird nur gesagt, was Menschen dazu geschrieben haben.</translation>
    </message>
    <message>
        <source>What a photograph shows is said briefly.</source>
        <translation>Was auf einem Foto zu sehen ist, wird kurz gesagt.</translation>
    </message>
    <message>
        <source>What a photograph shows is said in full.</source>
        <translation>Was auf einem Foto zu sehen ist, wird ausführlich gesagt.</translation>
    </message>
    <message>
        <source>descriptions</source>
        <translation>Beschreibungen</translation>
    </message>
    <message>
        <source>what is said first</source>
        <translation>was zuerst genannt wird</translation>
    </message>
    <message>
        <source>People come first.</source>
        <translation>Personen werden zuerst genannt.</translation>
    </message>
    <message>
        <source>Time and place come first.</source>
        <translation>Zeit und Ort werden zuerst genannt.</translation>
    </message>
</context>
<context>
    <name>tp::StartSession</name>
    <message>
        <source>Listen to photographs</source>
        <translation>Fotos anhören</translation>
    </message>
    <message>
        <source>One photograph after the other, with what was recorded for it</source>
        <translation>Ein Foto nach dem anderen, mit dem, was dazu aufgenommen wurde</translation>
    </message>
    <message>
        <source>Feel a face</source>
        <translation>Ein Gesicht fühlen</translation>
    </message>
    <message>
        <source>Your last photograph, under your finger</source>
        <translation>Ihr letztes Foto unter Ihrem Finger</translation>
    </message>
    <message>
        <source>Look after the album</source>
        <translation>Album pflegen</translation>
    </message>
    <message>
        <source>Import photographs, name people, record</source>
        <translation>Fotos importieren, Personen benennen, aufnehmen</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Speech, colours, force, where your photographs are</source>
        <translation>Sprache, Farben, Kraft, wo Ihre Fotos sind</translation>
    </message>
    <message>
        <source>Take a photograph</source>
        <translation>Foto aufnehmen</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Studien</translation>
    </message>
    <message>
        <source>TouchPhoto, start page. 1: %1. 2: %2. More below; F1 for help.</source>
        <translation>TouchPhoto, Startseite. 1: %1. 2: %2. Weiter unten mehr; F1 für Hilfe.</translation>
    </message>
    <message>
        <source>Lab</source>
        <translation>Labor</translation>
    </message>
    <message>
        <source>For researchers: guidance laws, their parameters, plots, recordings</source>
        <translation>Für die Forschung: Führungsgesetze, ihre Parameter, Diagramme, Aufnahmen</translation>
    </message>
    <message numerus="yes">
        <source>%n new photograph(s)</source>
        <translation>
            <numerusform>%n neues Foto</numerusform>
            <numerusform>%n neue Fotos</numerusform>
        </translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>%1, %2.</source>
        <translation>%1, %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n with people</source>
        <translation>
            <numerusform>%n mit Personen</numerusform>
            <numerusform>%n mit Personen</numerusform>
        </translation>
    </message>
    <message>
        <source>TouchPhoto, start page. %3 1: %1. 2: %2. More below; F1 for help.</source>
        <translation>TouchPhoto, Startseite. %3 1: %1. 2: %2. Weiter unten mehr; F1 für Hilfe.</translation>
    </message>
    <message>
        <source>The camera is led to a face by words and a tone</source>
        <translation>Worte und ein Ton führen die Kamera zu einem Gesicht</translation>
    </message>
    <message>
        <source>For researchers: the published experiments, with people</source>
        <translation>Für die Forschung: die veröffentlichten Experimente, mit Menschen</translation>
    </message>
</context>
<context>
    <name>tp::StorageSettings</name>
    <message>
        <source>No folder was chosen.</source>
        <translation>Es wurde kein Ordner ausgewählt.</translation>
    </message>
    <message>
        <source>This folder is already in the album.</source>
        <translation>Dieser Ordner ist schon im Album.</translation>
    </message>
    <message>
        <source>the added folder</source>
        <translation>der hinzugefügte Ordner</translation>
    </message>
    <message>
        <source>%1 now belongs to the album.</source>
        <translation>%1 gehört jetzt zum Album.</translation>
    </message>
    <message>
        <source>the removed folder</source>
        <translation>der entfernte Ordner</translation>
    </message>
    <message>
        <source>%1 no longer belongs to the album. Its photographs and recordings stay where they are.</source>
        <translation>%1 gehört nicht mehr zum Album. Die Fotos und Aufnahmen darin bleiben, wo sie sind.</translation>
    </message>
    <message>
        <source>Nothing leaves this computer: TouchPhoto connects to no other.</source>
        <translation>Nichts verlässt diesen Computer: TouchPhoto stellt keine Verbindung zu einem anderen her.</translation>
    </message>
    <message>
        <source>These settings, in %1.</source>
        <translation>Diese Einstellungen, in %1.</translation>
    </message>
    <message>
        <source>An index of the album, in %1 (%2). It can be deleted at any time.</source>
        <translation>Ein Index des Albums, in %1 (%2). Er kann jederzeit gelöscht werden.</translation>
    </message>
    <message>
        <source>Where your force device lies on the screen, in %1.</source>
        <translation>Wo Ihr Kraftgerät auf dem Bildschirm liegt, in %1.</translation>
    </message>
    <message>
        <source>Names, descriptions and recordings, beside the photographs in %1.</source>
        <translation>Namen, Beschreibungen und Aufnahmen, neben den Fotos in %1.</translation>
    </message>
    <message>
        <source>The photograph you opened last: %1.</source>
        <translation>Das zuletzt geöffnete Foto: %1.</translation>
    </message>
    <message>
        <source>The index is deleted when TouchPhoto ends, and rebuilt from the photographs at the next start.</source>
        <translation>Der Index wird gelöscht, wenn TouchPhoto endet, und beim nächsten Start aus den Fotos neu aufgebaut.</translation>
    </message>
    <message>
        <source>In that index, for each face of the album, numbers by which it is known again.</source>
        <translation>In diesem Index zu jedem Gesicht des Albums Zahlen, an denen es wiedererkannt wird.</translation>
    </message>
    <message>
        <source>comparing faces</source>
        <translation>der Vergleich von Gesichtern</translation>
    </message>
    <message>
        <source>Faces are compared, so that names can be offered.</source>
        <translation>Gesichter werden verglichen, damit Namen vorgeschlagen werden können.</translation>
    </message>
    <message>
        <source>Faces are not compared. What was kept about them is deleted; names stay.</source>
        <translation>Gesichter werden nicht verglichen. Was über sie gespeichert war, ist gelöscht; Namen bleiben.</translation>
    </message>
</context>
<context>
    <name>tp::StudyFinger</name>
    <message>
        <source>The force device is not there. Connect it.</source>
        <translation>Das Kraftgerät ist nicht da. Schließen Sie es an.</translation>
    </message>
    <message>
        <source>The device does not reach all of the experiment&apos;s surface, %1 by %2 millimetres: %3. Write a smaller surface into the experiment&apos;s file, or use the mouse.</source>
        <translation>Das Gerät erreicht nicht die ganze Fläche des Experiments, %1 mal %2 Millimeter: %3. Schreiben Sie eine kleinere Fläche in die Datei des Experiments oder verwenden Sie die Maus.</translation>
    </message>
</context>
<context>
    <name>tp::StudyKeeping</name>
    <message>
        <source>In this folder lies a study of another experiment, or of another version of it. Choose another folder.</source>
        <translation>In diesem Ordner liegt eine Studie mit einem anderen Experiment oder mit einer anderen Fassung davon. Wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>In this folder lies a study with simulated participants. Choose another folder.</source>
        <translation>In diesem Ordner liegt eine Studie mit simulierten Versuchspersonen. Wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>The study&apos;s folder cannot be read, because the computer reports: %1</source>
        <translation>Der Ordner der Studie kann nicht gelesen werden, denn der Computer meldet: %1</translation>
    </message>
    <message>
        <source>The study&apos;s folder cannot be opened, because the computer reports: %1</source>
        <translation>Der Ordner der Studie kann nicht geöffnet werden, denn der Computer meldet: %1</translation>
    </message>
    <message>
        <source>The study&apos;s folder is not open.</source>
        <translation>Der Ordner der Studie ist nicht geöffnet.</translation>
    </message>
    <message>
        <source>The trial cannot be kept, because the computer reports: %1</source>
        <translation>Der Durchgang kann nicht gespeichert werden, denn der Computer meldet: %1</translation>
    </message>
</context>
<context>
    <name>tp::StudyOverview</name>
    <message>
        <source>The study is being checked.</source>
        <translation>Die Studie wird geprüft.</translation>
    </message>
    <message>
        <source>No study has begun in this folder.</source>
        <translation>In diesem Ordner hat noch keine Studie begonnen.</translation>
    </message>
    <message>
        <source>Nothing is wrong in the folder.</source>
        <translation>Im Ordner ist alles in Ordnung.</translation>
    </message>
    <message>
        <source>Faults in the folder: %1.</source>
        <translation>Fehler im Ordner: %1.</translation>
    </message>
    <message>
        <source>The report is being made.</source>
        <translation>Der Bericht wird erstellt.</translation>
    </message>
    <message>
        <source>No trial counts yet, so that there is nothing to report.</source>
        <translation>Noch zählt kein Durchgang; es gibt nichts zu berichten.</translation>
    </message>
    <message>
        <source>The report is in %1. Open the file %2 there.</source>
        <translation>Der Bericht liegt in %1. Öffnen Sie dort die Datei %2.</translation>
    </message>
    <message>
        <source>The rest is on the page.</source>
        <translation>Der Rest steht auf der Seite.</translation>
    </message>
</context>
<context>
    <name>tp::StudyRun</name>
    <message>
        <source>%1 Press Space to try again.</source>
        <translation>%1 Die Leertaste versucht es noch einmal.</translation>
    </message>
    <message>
        <source>Your hand moves the finger with the mouse, on the screen or with the arrow keys, from where each trial begins. A tone says where the line is: faster is nearer, high is up, and it comes from the side where the line is.</source>
        <translation>Ihre Hand bewegt den Finger mit der Maus, auf dem Bildschirm oder mit den Pfeiltasten, von dort aus, wo der Durchgang beginnt. Ein Ton sagt, wo die Linie ist: schneller heißt näher, hoch heißt oben, und er kommt von der Seite, auf der die Linie ist.</translation>
    </message>
    <message>
        <source>That was the last trial. %1 Thank you. Press Space to end.</source>
        <translation>Das war der letzte Durchgang. %1 Vielen Dank. Die Leertaste beendet.</translation>
    </message>
    <message>
        <source>Time for a break. %1 Press Space to go on.</source>
        <translation>Zeit für eine Pause. %1 Mit der Leertaste geht es weiter.</translation>
    </message>
    <message>
        <source>The device brings your finger to the start. Let it lead you.</source>
        <translation>Das Gerät bringt Ihren Finger zum Anfang. Lassen Sie sich führen.</translation>
    </message>
    <message>
        <source>The device brings your finger to the start again.</source>
        <translation>Das Gerät bringt Ihren Finger noch einmal zum Anfang.</translation>
    </message>
    <message>
        <source>This trial has gone on for half an hour. Paused; it is done again. Press Space to go on.</source>
        <translation>Der Durchgang dauert schon eine halbe Stunde. Pause; der Durchgang wird wiederholt. Mit der Leertaste geht es weiter.</translation>
    </message>
    <message>
        <source>A part of the line was left out; the trial is done again.</source>
        <translation>Ein Teil der Linie wurde ausgelassen; der Durchgang wird wiederholt.</translation>
    </message>
    <message>
        <source>The time is over; the trial is done again.</source>
        <translation>Die Zeit ist um; der Durchgang wird wiederholt.</translation>
    </message>
    <message>
        <source>%1 The trial could not be kept and does not count. Press Space to do it again.</source>
        <translation>%1 Der Durchgang konnte nicht gespeichert werden und zählt nicht. Die Leertaste wiederholt ihn.</translation>
    </message>
    <message>
        <source>The end of the line was not reached; the trial is done again.</source>
        <translation>Das Ende der Linie wurde nicht erreicht; der Durchgang wird wiederholt.</translation>
    </message>
    <message>
        <source>The study has ended for participant %1.</source>
        <translation>Die Studie ist für Versuchsperson %1 zu Ende.</translation>
    </message>
    <message>
        <source>Paused. The trial is done again. Press Space to go on.</source>
        <translation>Pause. Der Durchgang wird wiederholt. Mit der Leertaste geht es weiter.</translation>
    </message>
    <message>
        <source>Paused. Press Space to go on.</source>
        <translation>Pause. Mit der Leertaste geht es weiter.</translation>
    </message>
    <message>
        <source>Nothing has been kept.</source>
        <translation>Es wurde nichts gespeichert.</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Beendet.</translation>
    </message>
    <message>
        <source>Stopped. Everything is kept. %1</source>
        <translation>Beendet. Alles ist gespeichert. %1</translation>
    </message>
    <message>
        <source>Stop the study? The force is off. Press Escape again to stop, or Space to go on.</source>
        <translation>Studie beenden? Die Kraft ist aus. Noch einmal Escape beendet sie, mit der Leertaste geht es weiter.</translation>
    </message>
    <message>
        <source>%1 %2.</source>
        <translation>%1 %2.</translation>
    </message>
    <message>
        <source>Waiting for consent</source>
        <translation>Wartet auf die Einwilligung</translation>
    </message>
    <message>
        <source>Getting ready</source>
        <translation>Wird vorbereitet</translation>
    </message>
    <message>
        <source>The finger is brought to the start</source>
        <translation>Der Finger wird zum Anfang gebracht</translation>
    </message>
    <message>
        <source>Press Space to start</source>
        <translation>Die Leertaste beginnt</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Waiting for an answer</source>
        <translation>Wartet auf eine Antwort</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>Wird gespeichert</translation>
    </message>
    <message>
        <source>Break. Press Space to go on</source>
        <translation>Erholungspause. Mit der Leertaste geht es weiter</translation>
    </message>
    <message>
        <source>Paused. Press Space to go on</source>
        <translation>Pause. Mit der Leertaste geht es weiter</translation>
    </message>
    <message>
        <source>Stop? Escape stops, Space goes on</source>
        <translation>Beenden? Escape beendet, mit der Leertaste geht es weiter</translation>
    </message>
    <message>
        <source>All trials are done. Press Space to end</source>
        <translation>Alle Durchgänge sind abgeschlossen. Die Leertaste beendet</translation>
    </message>
</context>
<context>
    <name>tp::StudySetup</name>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>Only a file on this computer can be opened.</source>
        <translation>Nur eine Datei auf diesem Computer kann geöffnet werden.</translation>
    </message>
    <message>
        <source>%1 cannot be used as an experiment. %2</source>
        <translation>%1 kann nicht als Experiment verwendet werden. %2</translation>
    </message>
    <message>
        <source>The experiment has more than 9 answers, which have no keys.</source>
        <translation>Das Experiment hat mehr als 9 Antworten; so viele Tasten gibt es dafür nicht.</translation>
    </message>
    <message>
        <source>Participants have numbers from 1 to %1.</source>
        <translation>Versuchspersonen haben Nummern von 1 bis %1.</translation>
    </message>
    <message>
        <source>Participant %1</source>
        <translation>Versuchsperson %1</translation>
    </message>
    <message>
        <source>Participant %1 is new.</source>
        <translation>Versuchsperson %1 ist neu.</translation>
    </message>
    <message>
        <source>The program&apos;s experiments are not there. Open an experiment&apos;s file.</source>
        <translation>Die Experimente des Programms sind nicht da. Öffnen Sie die Datei eines Experiments.</translation>
    </message>
    <message>
        <source>This experiment needs faces. Choose a folder with photographs named after person and expression, such as anna_smiling.jpg.</source>
        <translation>Dieses Experiment braucht Gesichter. Wählen Sie einen Ordner mit Fotos aus, die nach Person und Ausdruck benannt sind, etwa anna_smiling.jpg.</translation>
    </message>
    <message>
        <source>The faces are being read.</source>
        <translation>Die Gesichter werden gelesen.</translation>
    </message>
    <message>
        <source>The study&apos;s folder is being read.</source>
        <translation>Der Ordner der Studie wird gelesen.</translation>
    </message>
    <message>
        <source>The study lies in %1.</source>
        <translation>Die Studie liegt in %1.</translation>
    </message>
    <message>
        <source>No folder is chosen.</source>
        <translation>Es ist kein Ordner ausgewählt.</translation>
    </message>
    <message>
        <source>The faces are ready.</source>
        <translation>Die Gesichter sind bereit.</translation>
    </message>
    <message>
        <source>Mouse, touch or keys, with a tone</source>
        <translation>Maus, Berührung oder Tasten, mit einem Ton</translation>
    </message>
    <message>
        <source>The scene is shown, to try it out. Nothing is kept.</source>
        <translation>Die Szene wird zum Ausprobieren gezeigt. Nichts wird gespeichert.</translation>
    </message>
    <message>
        <source>The scene is not shown.</source>
        <translation>Die Szene wird nicht gezeigt.</translation>
    </message>
    <message>
        <source>Studies. %1. Keys 1 to %2 choose the experiment, S starts it, F1 says more.</source>
        <translation>Studien. %1. Die Tasten 1 bis %2 wählen das Experiment, S beginnt es, F1 sagt mehr.</translation>
    </message>
    <message>
        <source>The force may reach %1 newtons, as far as the device gives it, with your consent.</source>
        <translation>Mit Ihrer Einwilligung kann die Kraft %1 Newton erreichen, soweit das Gerät sie aufbringt.</translation>
    </message>
    <message>
        <source>This study asks for up to %1 newtons. The force is cut at %2 newtons, in %3 of %4 conditions, unless you consent to more. Key: L.</source>
        <translation>Diese Studie verlangt bis zu %1 Newton. Die Kraft ist auf %2 Newton begrenzt, in %3 von %4 Bedingungen, wenn Sie nicht in mehr einwilligen. Taste: L.</translation>
    </message>
    <message>
        <source>This study asks for no more force than the settings allow.</source>
        <translation>Diese Studie verlangt nicht mehr Kraft, als die Einstellungen zulassen.</translation>
    </message>
</context>
<context>
    <name>tp::TagPlayback</name>
    <message>
        <source>Next: %1.</source>
        <translation>Als Nächstes: %1.</translation>
    </message>
</context>
<context>
    <name>tp::Take</name>
    <message>
        <source>Recording</source>
        <translation>Aufnahme läuft</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>Wird gespeichert…</translation>
    </message>
    <message>
        <source>Waiting for the microphone…</source>
        <translation>Warten auf das Mikrofon…</translation>
    </message>
    <message>
        <source>nothing heard</source>
        <translation>nichts zu hören</translation>
    </message>
    <message>
        <source>soft</source>
        <translation>leise</translation>
    </message>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>too loud</source>
        <translation>zu laut</translation>
    </message>
    <message>
        <source>The recorder is still busy. Try again in a moment.</source>
        <translation>Das Aufnehmen ist noch nicht abgeschlossen. Versuchen Sie es gleich noch einmal.</translation>
    </message>
    <message>
        <source>Paused.</source>
        <translation>Angehalten.</translation>
    </message>
    <message>
        <source>Discard what was recorded? It cannot be brought back.</source>
        <translation>Das Aufgenommene verwerfen? Es kann nicht zurückgeholt werden.</translation>
    </message>
    <message>
        <source>Discarded. Nothing was changed.</source>
        <translation>Verworfen. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Kept. The recording is paused.</source>
        <translation>Behalten. Die Aufnahme ist angehalten.</translation>
    </message>
    <message>
        <source>%1 Saved.</source>
        <translation>%1 Gespeichert.</translation>
    </message>
    <message>
        <source>The album is still being changed. Try again in a moment.</source>
        <translation>Das Album wird noch geändert. Versuchen Sie es gleich noch einmal.</translation>
    </message>
</context>
<context>
    <name>tp::TickSettings</name>
    <message>
        <source>what ticks</source>
        <translation>was tickt</translation>
    </message>
    <message>
        <source>Ticks: %1.</source>
        <translation>Ticks: %1.</translation>
    </message>
    <message>
        <source>the strength of ticks</source>
        <translation>die Stärke der Ticks</translation>
    </message>
    <message>
        <source>Strength of ticks: %1 percent.</source>
        <translation>Stärke der Ticks: %1 Prozent.</translation>
    </message>
    <message>
        <source>the sharpness of ticks</source>
        <translation>die Schärfe der Ticks</translation>
    </message>
    <message>
        <source>Sharpness of ticks: %1 percent.</source>
        <translation>Schärfe der Ticks: %1 Prozent.</translation>
    </message>
    <message>
        <source>how late ticks are felt</source>
        <translation>wie spät Ticks gefühlt werden</translation>
    </message>
    <message numerus="yes">
        <source>Ticks are felt %n millisecond(s) late.</source>
        <translation>
            <numerusform>Ticks werden %n Millisekunde zu spät gefühlt.</numerusform>
            <numerusform>Ticks werden %n Millisekunden zu spät gefühlt.</numerusform>
        </translation>
    </message>
    <message>
        <source>There is nothing here that ticks under a finger.</source>
        <translation>Hier ist nichts, was unter einem Finger ticken kann.</translation>
    </message>
    <message>
        <source>Now.</source>
        <translation>Jetzt.</translation>
    </message>
    <message>
        <source>Seven ticks come. Press Space as soon as you feel one. The time from a tick to the key, less what people usually take, is how late ticks are felt; it is only about right.</source>
        <translation>Es kommen sieben Ticks. Drücken Sie die Leertaste, sobald Sie einen fühlen. Die Zeit vom Tick bis zur Taste, weniger die, die Menschen gewöhnlich brauchen, ist die Verspätung; sie stimmt nur ungefähr.</translation>
    </message>
    <message>
        <source>What ticks is gone.</source>
        <translation>Was tickt, ist nicht mehr da.</translation>
    </message>
    <message>
        <source>Too few ticks were answered. Nothing was changed.</source>
        <translation>Zu wenige Ticks wurden beantwortet. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Ended.</source>
        <translation>Beendet.</translation>
    </message>
</context>
<context>
    <name>tp::Trimming</name>
    <message>
        <source>%1 of %2 stay.</source>
        <translation>%1 von %2 bleiben.</translation>
    </message>
    <message>
        <source>All of it stays.</source>
        <translation>Alles bleibt.</translation>
    </message>
    <message>
        <source>From %1</source>
        <translation>Von %1</translation>
    </message>
    <message>
        <source>To %1</source>
        <translation>Bis %1</translation>
    </message>
    <message>
        <source>All of it stays, so there is nothing to cut off. Move the start or the end first.</source>
        <translation>Alles bleibt, es gibt also nichts abzuschneiden. Verschieben Sie zuerst den Anfang oder das Ende.</translation>
    </message>
    <message>
        <source>Trimmed: %1 stay. Undo brings the rest back.</source>
        <translation>Gekürzt: %1 bleiben. „Rückgängig“ bringt den Rest zurück.</translation>
    </message>
</context>
</TS>
