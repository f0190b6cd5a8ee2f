<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ko" sourcelanguage="en">
<context>
    <name>BrowseButtons</name>
    <message>
        <source>Choose folders</source>
        <translation>폴더 선택</translation>
    </message>
    <message>
        <source>On the settings page</source>
        <translation>설정 페이지에서 고릅니다</translation>
    </message>
    <message>
        <source>Import photographs</source>
        <translation>사진 가져오기</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>일시 정지</translation>
    </message>
    <message>
        <source>Play recordings</source>
        <translation>녹음 재생</translation>
    </message>
    <message>
        <source>On the detail of a recording: that one alone. Key: Return</source>
        <translation>녹음 정보 위에서는 그 녹음만 재생합니다. 엔터 키</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>이전</translation>
    </message>
    <message>
        <source>Photograph. Key: left arrow</source>
        <translation>사진. 왼쪽 화살표 키</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>다음</translation>
    </message>
    <message>
        <source>Photograph. Key: right arrow</source>
        <translation>사진. 오른쪽 화살표 키</translation>
    </message>
    <message>
        <source>Previous detail</source>
        <translation>이전 정보</translation>
    </message>
    <message>
        <source>Key: up arrow</source>
        <translation>위쪽 화살표 키</translation>
    </message>
    <message>
        <source>Next detail</source>
        <translation>다음 정보</translation>
    </message>
    <message>
        <source>People, recordings, descriptions, place and time. Key: down arrow</source>
        <translation>사람, 녹음, 설명, 장소와 시간. 아래쪽 화살표 키</translation>
    </message>
    <message>
        <source>Feel the face</source>
        <translation>얼굴 만져 보기</translation>
    </message>
    <message>
        <source>Key: E</source>
        <translation>E 키</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>뒤로</translation>
    </message>
    <message>
        <source>To the previous list. Key: Backspace</source>
        <translation>이전 목록으로 갑니다. 백스페이스 키</translation>
    </message>
    <message>
        <source>All photographs</source>
        <translation>모든 사진</translation>
    </message>
    <message>
        <source>Key: A</source>
        <translation>A 키</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>검색</translation>
    </message>
    <message>
        <source>Key: S</source>
        <translation>S 키</translation>
    </message>
    <message>
        <source>Surprise me</source>
        <translation>아무 사진이나 듣기</translation>
    </message>
    <message>
        <source>Any photograph. Key: R</source>
        <translation>무작위로 고른 사진. R 키</translation>
    </message>
    <message>
        <source>People</source>
        <translation>사람</translation>
    </message>
    <message>
        <source>Key: P</source>
        <translation>P 키</translation>
    </message>
    <message>
        <source>Years</source>
        <translation>연도</translation>
    </message>
    <message>
        <source>Key: Y</source>
        <translation>Y 키</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>장소</translation>
    </message>
    <message>
        <source>Key: L</source>
        <translation>L 키</translation>
    </message>
    <message>
        <source>Keywords</source>
        <translation>키워드</translation>
    </message>
    <message>
        <source>Key: K</source>
        <translation>K 키</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>느리게</translation>
    </message>
    <message>
        <source>%1. Key: minus</source>
        <translation>%1. 빼기 키</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>빠르게</translation>
    </message>
    <message>
        <source>%1. Key: plus</source>
        <translation>%1. 더하기 키</translation>
    </message>
    <message>
        <source>Where am I?</source>
        <translation>여기는 어디인가요?</translation>
    </message>
    <message>
        <source>Key: W</source>
        <translation>W 키</translation>
    </message>
    <message>
        <source>Look after it</source>
        <translation>관리</translation>
    </message>
    <message>
        <source>Names, recordings and descriptions of this photograph. Key: C</source>
        <translation>이 사진의 이름, 녹음, 설명. C 키</translation>
    </message>
</context>
<context>
    <name>BrowseKeys</name>
    <message>
        <source>Left, Right: photograph · Up, Down: details · Enter: recordings · Escape: stop · +, −: speed
Home, End: first, last · S: search · P: people · Y: years · L: places · K: keywords · R: surprise
A: all · Backspace: back · E: feel the face · C: look after it · W: where am I · H: keys</source>
        <translation>왼쪽, 오른쪽: 사진 · 위, 아래: 정보 · 엔터: 녹음 · Escape: 멈춤 · +, −: 속도
Home, End: 처음, 마지막 · S: 검색 · P: 사람 · Y: 연도 · L: 장소 · K: 키워드 · R: 아무 사진
A: 모두 · 백스페이스: 뒤로 · E: 얼굴 만져 보기 · C: 사진 관리 · W: 현재 위치 · H: 키 목록</translation>
    </message>
</context>
<context>
    <name>CalibrationView</name>
    <message>
        <source>Calibration</source>
        <translation>보정</translation>
    </message>
    <message>
        <source>End the calibration</source>
        <translation>보정 끝내기</translation>
    </message>
    <message>
        <source>Nothing is changed. Key: Escape</source>
        <translation>아무것도 바뀌지 않습니다. 키: Escape</translation>
    </message>
</context>
<context>
    <name>CarePage</name>
    <message>
        <source>Tab goes from control to control, the arrow keys from photograph to photograph, Return opens one. Control Z undoes the last step, Control Shift Z redoes it. Escape stops what plays, and ends a recording and keeps it.</source>
        <translation>탭 키로 항목 사이를, 화살표 키로 사진 사이를 이동하고, 엔터 키로 사진을 엽니다. Ctrl Z는 마지막 작업을 되돌리고, Ctrl Shift Z는 다시 실행합니다. Escape 키는 재생을 멈추고, 녹음 중이면 녹음을 끝내고 보관합니다.</translation>
    </message>
</context>
<context>
    <name>CareWords</name>
    <message>
        <source>Memo</source>
        <translation>메모</translation>
    </message>
    <message>
        <source>Who it is</source>
        <translation>누구인지</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>장소</translation>
    </message>
    <message>
        <source>Story</source>
        <translation>이야기</translation>
    </message>
    <message>
        <source>Sounds around</source>
        <translation>주변 소리</translation>
    </message>
    <message>
        <source>%1, about %2</source>
        <translation>%1, %2에 대하여</translation>
    </message>
    <message>
        <source>spoken by %1</source>
        <translation>말한 사람: %1</translation>
    </message>
    <message>
        <source>%1 seconds</source>
        <translation>%1초</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s).</source>
        <translation>
            <numerusform>녹음 %n개.</numerusform>
        </translation>
    </message>
    <message>
        <source>No description.</source>
        <translation>설명 없음.</translation>
    </message>
    <message>
        <source>%1 of %2 photographs, %3 of %4 megabytes</source>
        <translation>사진 %2장 중 %1장, %4메가바이트 중 %3메가바이트</translation>
    </message>
    <message>
        <source>%1, about %2 left</source>
        <translation>%1, 약 %2 남음</translation>
    </message>
    <message>
        <source>The import was stopped before the first photograph.</source>
        <translation>첫 사진을 가져오기 전에 중단되었습니다.</translation>
    </message>
    <message>
        <source>There is no photograph among what was chosen.</source>
        <translation>선택한 것 가운데 사진이 없습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s) imported</source>
        <translation>
            <numerusform>사진 %n장 가져옴</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of them there already</source>
        <translation>
            <numerusform>이미 있는 사진 %n장</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n failed</source>
        <translation>
            <numerusform>실패 %n장</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 The import was stopped; it can go on later.</source>
        <translation>%1 가져오기가 중단되었습니다. 나중에 이어서 할 수 있습니다.</translation>
    </message>
</context>
<context>
    <name>DescriptionPart</name>
    <message>
        <source>Description</source>
        <translation>설명</translation>
    </message>
    <message>
        <source>In one sentence (%1)</source>
        <translation>한 문장으로 (%1)</translation>
    </message>
    <message>
        <source>%1 characters; a screen reader reads up to 250 in one piece.</source>
        <translation>%1자입니다. 화면 낭독기는 한 번에 250자까지 읽습니다.</translation>
    </message>
    <message>
        <source>%1 of 250 characters</source>
        <translation>250자 중 %1자</translation>
    </message>
    <message>
        <source>In more words (%1)</source>
        <translation>더 자세히 (%1)</translation>
    </message>
    <message>
        <source>%1 characters</source>
        <translation>%1자</translation>
    </message>
    <message>
        <source>Save the description</source>
        <translation>설명 저장</translation>
    </message>
    <message>
        <source>The description is saved</source>
        <translation>설명이 저장되었습니다</translation>
    </message>
    <message>
        <source>It is saved too when a field is left.</source>
        <translation>입력란을 벗어날 때에도 저장됩니다.</translation>
    </message>
</context>
<context>
    <name>DialogLoader</name>
    <message>
        <source>The file dialog is not installed. Drop files or folders on this window instead.</source>
        <translation>파일 대화 상자가 설치되어 있지 않습니다. 대신 이 창에 파일이나 폴더를 끌어다 놓으세요.</translation>
    </message>
</context>
<context>
    <name>Duration</name>
    <message>
        <source>1 hour</source>
        <translation>1시간</translation>
    </message>
    <message>
        <source>%1 hours</source>
        <translation>%1시간</translation>
    </message>
    <message>
        <source>1 minute</source>
        <translation>1분</translation>
    </message>
    <message>
        <source>%1 minutes</source>
        <translation>%1분</translation>
    </message>
    <message>
        <source>1 second</source>
        <translation>1초</translation>
    </message>
    <message>
        <source>%1 seconds</source>
        <translation>%1초</translation>
    </message>
</context>
<context>
    <name>ExplorePage</name>
    <message>
        <source>The file dialog is not installed. Drop a photograph on this window instead.</source>
        <translation>파일 대화 상자가 설치되어 있지 않습니다. 대신 이 창에 사진을 끌어다 놓으세요.</translation>
    </message>
</context>
<context>
    <name>FaceTargets</name>
    <message>
        <source>Fits this face into the surface</source>
        <translation>이 얼굴을 터치 영역에 맞춥니다</translation>
    </message>
    <message>
        <source>Sets the finger down there</source>
        <translation>그곳에 손가락을 놓습니다</translation>
    </message>
</context>
<context>
    <name>FacesPart</name>
    <message>
        <source>Faces</source>
        <translation>얼굴</translation>
    </message>
    <message>
        <source>Press to name it</source>
        <translation>누르면 이름을 붙일 수 있습니다</translation>
    </message>
    <message>
        <source>Who is face %1?</source>
        <translation>%1번 얼굴은 누구인가요?</translation>
    </message>
    <message>
        <source>Nobody I know</source>
        <translation>모르는 사람</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>닫기</translation>
    </message>
    <message>
        <source>Leaves the face as it is.</source>
        <translation>얼굴을 그대로 둡니다.</translation>
    </message>
    <message>
        <source>Its name is read as</source>
        <translation>이름을 읽는 언어</translation>
    </message>
    <message>
        <source>As the page</source>
        <translation>페이지와 같게</translation>
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
        <source>Take this folder</source>
        <translation>이 폴더로 정하기</translation>
    </message>
    <message>
        <source>To the folder above</source>
        <translation>상위 폴더로</translation>
    </message>
    <message>
        <source>Do not choose a folder</source>
        <translation>폴더를 고르지 않기</translation>
    </message>
</context>
<context>
    <name>ImportPart</name>
    <message>
        <source>Stop the import</source>
        <translation>가져오기 중단</translation>
    </message>
    <message>
        <source>Import photographs…</source>
        <translation>사진 가져오기…</translation>
    </message>
    <message>
        <source>Or drop them on this window.</source>
        <translation>이 창에 끌어다 놓아도 됩니다.</translation>
    </message>
    <message>
        <source>Import a folder…</source>
        <translation>폴더 가져오기…</translation>
    </message>
    <message>
        <source>Into</source>
        <translation>가져올 곳</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>가져오기</translation>
    </message>
    <message>
        <source>Continue the unfinished import</source>
        <translation>끝나지 않은 가져오기 계속하기</translation>
    </message>
    <message>
        <source>Give up the unfinished import</source>
        <translation>끝나지 않은 가져오기 그만두기</translation>
    </message>
    <message>
        <source>What it brought stays.</source>
        <translation>이미 가져온 사진은 남습니다.</translation>
    </message>
</context>
<context>
    <name>KeyHelp</name>
    <message>
        <source>Touch: one finger explores. Double tap: where am I. Double tap and hold: zoom to what is there, or out. Two-finger tap: stop. Two-finger double tap: tour. Three-finger tap: where am I.</source>
        <translation>터치: 한 손가락으로 살펴보기. 두 번 두드리기: 현재 위치. 두 번 두드리고 누르고 있기: 그곳을 확대하거나 축소. 두 손가락으로 두드리기: 멈춤. 두 손가락으로 두 번 두드리기: 안내. 세 손가락으로 두드리기: 현재 위치.</translation>
    </message>
    <message>
        <source>In the picture: ring, the hand; disc, the finger; arrow, the pull of the line.</source>
        <translation>화면에서: 고리는 손, 원판은 손가락, 화살표는 선이 당기는 힘입니다.</translation>
    </message>
    <message>
        <source>Arrow keys, with Shift faster: move the hand. Tab: next feature. W: where am I. Z, Shift+Z: zoom in and out. Space: tour of the feature. T: tour of the face. G: guide. F: next face. N, Shift+N: next and previous photograph with a face. Enter: force on. Escape: stop. V: voice. O: open.</source>
        <translation>화살표 키: 손 이동, Shift와 함께 누르면 더 빠르게. 탭 키: 다음 부위. W: 현재 위치. Z, Shift+Z: 확대와 축소. 스페이스바: 부위 안내. T: 얼굴 안내. G: 길잡이. F: 다음 얼굴. N, Shift+N: 얼굴이 있는 다음 사진과 이전 사진. 엔터 키: 힘 켜기. Escape 키: 멈춤. V: 음성. O: 열기.</translation>
    </message>
</context>
<context>
    <name>LabControls</name>
    <message>
        <source>What is felt</source>
        <translation>만져지는 것</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>장면</translation>
    </message>
    <message>
        <source>Open a photograph…</source>
        <translation>사진 열기…</translation>
    </message>
    <message>
        <source>Key: O. One can be dropped on the page too</source>
        <translation>O 키. 페이지에 끌어다 놓아도 됩니다</translation>
    </message>
    <message>
        <source>Law</source>
        <translation>유도 법칙</translation>
    </message>
    <message>
        <source>Stiffness K</source>
        <translation>강성 K</translation>
    </message>
    <message>
        <source>Range d</source>
        <translation>범위 d</translation>
    </message>
    <message>
        <source>Hysteresis at switches</source>
        <translation>전환 시 히스테리시스</translation>
    </message>
    <message>
        <source>Blending at switches</source>
        <translation>전환 시 블렌딩</translation>
    </message>
    <message>
        <source>Corner cue</source>
        <translation>모서리 신호</translation>
    </message>
    <message>
        <source>Spacing of vertices</source>
        <translation>꼭짓점 간격</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>서보</translation>
    </message>
    <message>
        <source>Strongest force</source>
        <translation>최대 힘</translation>
    </message>
    <message>
        <source>Damping across a line</source>
        <translation>선에 수직인 방향의 감쇠</translation>
    </message>
    <message>
        <source>Energy observer</source>
        <translation>에너지 관측기</translation>
    </message>
    <message>
        <source>Limits of a real device</source>
        <translation>실제 장치의 한계</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>장치</translation>
    </message>
    <message>
        <source>Look for devices again</source>
        <translation>장치 다시 찾기</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>질량</translation>
    </message>
    <message>
        <source>Damping of the device</source>
        <translation>장치의 감쇠</translation>
    </message>
    <message>
        <source>Dry friction</source>
        <translation>건마찰</translation>
    </message>
    <message>
        <source>Encoder step</source>
        <translation>엔코더 간격</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>지연</translation>
    </message>
    <message>
        <source>Grip of the hand</source>
        <translation>손으로 쥐는 세기</translation>
    </message>
    <message>
        <source>Damping of the hand</source>
        <translation>손의 감쇠</translation>
    </message>
    <message>
        <source>Faults of the simulated device</source>
        <translation>모의 장치의 고장</translation>
    </message>
    <message>
        <source>Readings that do not come</source>
        <translation>누락되는 측정값</translation>
    </message>
    <message>
        <source>No readings at all</source>
        <translation>측정값 전혀 없음</translation>
    </message>
    <message>
        <source>Takes no force</source>
        <translation>힘을 받지 않음</translation>
    </message>
    <message>
        <source>Motors off by themselves</source>
        <translation>모터가 저절로 꺼짐</translation>
    </message>
    <message>
        <source>Unplugged</source>
        <translation>연결이 뽑힘</translation>
    </message>
    <message>
        <source>Hang for 200 milliseconds</source>
        <translation>200밀리초 동안 멈추기</translation>
    </message>
    <message>
        <source>All parameters</source>
        <translation>모든 매개변수</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>되돌릴 것이 없습니다</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>되돌리기: %1</translation>
    </message>
    <message>
        <source>Key: Control Z</source>
        <translation>Ctrl Z 키</translation>
    </message>
    <message>
        <source>As they were at first</source>
        <translation>처음 상태로</translation>
    </message>
    <message>
        <source>It can be undone</source>
        <translation>되돌릴 수 있습니다</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>파일</translation>
    </message>
    <message>
        <source>In %1</source>
        <translation>위치: %1</translation>
    </message>
    <message>
        <source>Write the plots as a table</source>
        <translation>그래프를 표로 저장</translation>
    </message>
    <message>
        <source>CSV, with the parameters as JSON beside it</source>
        <translation>CSV 파일로 저장하고, 매개변수는 그 옆에 JSON으로 둡니다</translation>
    </message>
    <message>
        <source>No recordings yet.</source>
        <translation>아직 기록이 없습니다.</translation>
    </message>
    <message>
        <source>Replay %1</source>
        <translation>다시 재생: %1</translation>
    </message>
    <message>
        <source>Guidance</source>
        <translation>유도</translation>
    </message>
    <message>
        <source>The strongest force of real devices</source>
        <translation>실제 장치의 가장 강한 힘</translation>
    </message>
    <message>
        <source>Goes to the settings</source>
        <translation>설정으로 갑니다</translation>
    </message>
</context>
<context>
    <name>LabOpenDialog</name>
    <message>
        <source>Open photograph</source>
        <translation>사진 열기</translation>
    </message>
    <message>
        <source>Photographs (%1)</source>
        <translation>사진 (%1)</translation>
    </message>
    <message>
        <source>All files (%1)</source>
        <translation>모든 파일 (%1)</translation>
    </message>
</context>
<context>
    <name>LabPage</name>
    <message>
        <source>Start the servo</source>
        <translation>서보 켜기</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>멈춤</translation>
    </message>
    <message>
        <source>Key: Space on the surface; Escape stops</source>
        <translation>터치 영역에서 스페이스바. Escape 키로 멈춥니다</translation>
    </message>
    <message>
        <source>End the recording</source>
        <translation>기록 끝내기</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>기록</translation>
    </message>
    <message>
        <source>Key: R</source>
        <translation>R 키</translation>
    </message>
    <message>
        <source>Where is the finger?</source>
        <translation>손가락은 어디에 있나요?</translation>
    </message>
    <message>
        <source>Key: W</source>
        <translation>W 키</translation>
    </message>
    <message>
        <source>Read the plots</source>
        <translation>그래프 읽기</translation>
    </message>
    <message>
        <source>Key: P</source>
        <translation>P 키</translation>
    </message>
    <message>
        <source>On the surface arrow keys move the hand and Space starts and stops the servo. R records, W says where the finger is, P reads the plots, O opens a photograph, Control Z undoes a change. Escape stops what runs.</source>
        <translation>터치 영역에서 화살표 키는 손을 움직이고 스페이스바는 서보를 켜고 끕니다. R은 기록, W는 손가락의 위치, P는 그래프 읽기, O는 사진 열기이며, Ctrl Z는 변경을 되돌립니다. Escape 키는 실행 중인 것을 멈춥니다.</translation>
    </message>
</context>
<context>
    <name>LabSurface</name>
    <message>
        <source>Arrow keys move the hand by 2 millimetres, with Shift by 10. Space starts and stops the servo.</source>
        <translation>화살표 키는 손을 2밀리미터씩, Shift와 함께 누르면 10밀리미터씩 움직입니다. 스페이스바는 서보를 켜고 끕니다.</translation>
    </message>
</context>
<context>
    <name>LabWords</name>
    <message>
        <source>Position: nothing measured yet.</source>
        <translation>위치: 아직 측정값이 없습니다.</translation>
    </message>
    <message>
        <source>Force |F|: nothing measured yet.</source>
        <translation>힘 |F|: 아직 측정값이 없습니다.</translation>
    </message>
    <message>
        <source>Energy: nothing measured yet.</source>
        <translation>에너지: 아직 측정값이 없습니다.</translation>
    </message>
    <message>
        <source>Lateness: nothing measured yet.</source>
        <translation>늦어짐: 아직 측정값이 없습니다.</translation>
    </message>
    <message>
        <source>%1 newtons per millimetre</source>
        <translation>밀리미터당 %1뉴턴</translation>
    </message>
    <message>
        <source>%1 newtons</source>
        <translation>%1뉴턴</translation>
    </message>
    <message>
        <source>%1 newton seconds per metre</source>
        <translation>미터당 %1뉴턴초</translation>
    </message>
    <message>
        <source>%1 grams</source>
        <translation>%1그램</translation>
    </message>
    <message numerus="yes">
        <source>%n tick(s)</source>
        <translation>
            <numerusform>%n틱</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 percent</source>
        <translation>%1퍼센트</translation>
    </message>
    <message>
        <source>%1 of critical damping</source>
        <translation>임계 감쇠의 %1배</translation>
    </message>
    <message>
        <source>%1 millimetres</source>
        <translation>%1밀리미터</translation>
    </message>
    <message>
        <source>%1, %2 of the middle</source>
        <translation>중심에서 %1, %2</translation>
    </message>
    <message>
        <source>%1 mm left</source>
        <translation>왼쪽으로 %1 mm</translation>
    </message>
    <message>
        <source>%1 mm right</source>
        <translation>오른쪽으로 %1 mm</translation>
    </message>
    <message>
        <source>%1 mm below</source>
        <translation>아래로 %1 mm</translation>
    </message>
    <message>
        <source>%1 mm above</source>
        <translation>위로 %1 mm</translation>
    </message>
    <message>
        <source>Position now x %1, y %2 mm; x from %3 to %4, y from %5 to %6.</source>
        <translation>현재 위치 x %1, y %2 mm. x의 범위 %3부터 %4, y의 범위 %5부터 %6.</translation>
    </message>
    <message>
        <source>Force |F| now %1 newtons, at most %2.</source>
        <translation>현재 힘 |F| %1뉴턴, 최대 %2.</translation>
    </message>
    <message>
        <source>Energy given to the hand now %1 millijoules, from %2 to %3.</source>
        <translation>손에 전달된 에너지, 현재 %1밀리줄, 범위 %2부터 %3.</translation>
    </message>
    <message>
        <source>Ticks late by now %1 milliseconds, at most %2.</source>
        <translation>틱의 늦어짐, 현재 %1밀리초, 최대 %2.</translation>
    </message>
    <message>
        <source>Computed again, the forces differ by at most %1 newtons.</source>
        <translation>다시 계산한 힘과의 차이는 최대 %1뉴턴입니다.</translation>
    </message>
    <message>
        <source>Its parameters are not beside it, so it was not computed again.</source>
        <translation>옆에 매개변수가 없어 다시 계산하지 않았습니다.</translation>
    </message>
    <message>
        <source>Its end was cut short and is left out.</source>
        <translation>끝부분이 잘려 있어 제외했습니다.</translation>
    </message>
</context>
<context>
    <name>LabelPart</name>
    <message>
        <source>Kind</source>
        <translation>종류</translation>
    </message>
    <message>
        <source>About whom</source>
        <translation>누구에 대한 녹음인지</translation>
    </message>
    <message>
        <source>About nobody in particular</source>
        <translation>특정한 사람 없음</translation>
    </message>
    <message>
        <source>Who speaks</source>
        <translation>말하는 사람</translation>
    </message>
    <message>
        <source>Speaker not said</source>
        <translation>말하는 사람 지정 안 함</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>언어</translation>
    </message>
</context>
<context>
    <name>MeasuringView</name>
    <message>
        <source>Measuring the stick</source>
        <translation>힘 스틱 재기</translation>
    </message>
    <message>
        <source>Grams on the scale</source>
        <translation>저울의 그램 수</translation>
    </message>
    <message>
        <source>Type, or use the slider below</source>
        <translation>입력하거나 아래 슬라이더를 쓰십시오</translation>
    </message>
    <message>
        <source>Grams, in steps of five</source>
        <translation>그램, 다섯 단위로</translation>
    </message>
    <message>
        <source>%1 grams</source>
        <translation>%1그램</translation>
    </message>
    <message>
        <source>The scale shows this</source>
        <translation>저울이 이렇게 보여 줍니다</translation>
    </message>
    <message>
        <source>End the measurement</source>
        <translation>재기 끝내기</translation>
    </message>
    <message>
        <source>Nothing is changed. Key: Escape</source>
        <translation>아무것도 바뀌지 않습니다. 키: Escape</translation>
    </message>
</context>
<context>
    <name>MendPage</name>
    <message>
        <source>Tab goes from point to point of the photograph&apos;s lines, page up and page down from feature to feature. Arrow keys move a point by one pixel, with Shift by ten, with Control by a fifth. A adds a point, Delete takes it away, C turns a corner into a smooth point. Control Z undoes the last step, Control S saves; leaving the page saves too.</source>
        <translation>탭 키는 사진 위 선의 점에서 점으로, 페이지 업과 페이지 다운 키는 부위에서 부위로 갑니다. 화살표 키는 점을 1픽셀씩, Shift와 함께 10픽셀씩, Ctrl과 함께 5분의 1픽셀씩 옮깁니다. A는 점을 더하고, Delete는 점을 지우고, C는 모서리를 매끄러운 점으로 바꿉니다. Ctrl Z는 마지막 단계를 되돌리고, Ctrl S는 저장합니다. 페이지를 떠날 때도 저장됩니다.</translation>
    </message>
</context>
<context>
    <name>MendPanel</name>
    <message>
        <source>Mend contours</source>
        <translation>윤곽선 고치기</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>저장</translation>
    </message>
    <message>
        <source>Leaving this page saves too. Key: Control+S</source>
        <translation>이 페이지를 떠날 때에도 저장됩니다. Ctrl+S 키</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>되돌리기</translation>
    </message>
    <message>
        <source>Key: Control+Z</source>
        <translation>Ctrl+Z 키</translation>
    </message>
    <message>
        <source>Feature</source>
        <translation>부위</translation>
    </message>
    <message>
        <source>In hand</source>
        <translation>선택된 것</translation>
    </message>
    <message>
        <source>%1: not there</source>
        <translation>%1: 없음</translation>
    </message>
    <message>
        <source>%1 of the %2: %3</source>
        <translation>%2, %1: %3</translation>
    </message>
    <message>
        <source>Previous point</source>
        <translation>이전 점</translation>
    </message>
    <message>
        <source>Key: Shift+Tab on the photograph</source>
        <translation>사진에서 Shift+탭 키</translation>
    </message>
    <message>
        <source>Next point</source>
        <translation>다음 점</translation>
    </message>
    <message>
        <source>Key: Tab on the photograph</source>
        <translation>사진에서 탭 키</translation>
    </message>
    <message>
        <source>Move left</source>
        <translation>왼쪽으로 옮기기</translation>
    </message>
    <message>
        <source>Move right</source>
        <translation>오른쪽으로 옮기기</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>위로 옮기기</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>아래로 옮기기</translation>
    </message>
    <message>
        <source>By one pixel of the photograph. Arrow keys: with Shift by ten, with Control by a fifth</source>
        <translation>사진의 1픽셀만큼 옮깁니다. 화살표 키: Shift와 함께 누르면 10픽셀, Ctrl과 함께 누르면 5분의 1픽셀</translation>
    </message>
    <message>
        <source>Move the whole feature</source>
        <translation>부위 전체 옮기기</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>점 추가</translation>
    </message>
    <message>
        <source>Behind the one in hand. Key: A. Or double-click beside a line</source>
        <translation>선택된 점 뒤에 추가합니다. A 키. 또는 선 옆을 두 번 클릭하세요</translation>
    </message>
    <message>
        <source>Delete the point</source>
        <translation>점 삭제</translation>
    </message>
    <message>
        <source>Key: Delete</source>
        <translation>Delete 키</translation>
    </message>
    <message>
        <source>Make it smooth</source>
        <translation>매끄럽게 만들기</translation>
    </message>
    <message>
        <source>Make it a corner</source>
        <translation>모서리로 만들기</translation>
    </message>
    <message>
        <source>Key: C</source>
        <translation>C 키</translation>
    </message>
    <message>
        <source>As it was found</source>
        <translation>처음 찾은 대로</translation>
    </message>
    <message>
        <source>Undoes what was done to this feature alone</source>
        <translation>이 부위에 한 작업만 되돌립니다</translation>
    </message>
    <message>
        <source>Remove the feature</source>
        <translation>부위 없애기</translation>
    </message>
    <message>
        <source>It will not be felt</source>
        <translation>만져지지 않게 됩니다</translation>
    </message>
    <message>
        <source>Add the %1</source>
        <translation>%1 추가</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>크게</translation>
    </message>
    <message>
        <source>Key: Plus</source>
        <translation>더하기 키</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>작게</translation>
    </message>
    <message>
        <source>Key: Minus</source>
        <translation>빼기 키</translation>
    </message>
    <message>
        <source>Whole photograph</source>
        <translation>사진 전체</translation>
    </message>
    <message>
        <source>Key: 0</source>
        <translation>0 키</translation>
    </message>
    <message>
        <source>This feature</source>
        <translation>이 부위</translation>
    </message>
    <message>
        <source>Fits it into view. Key: Z</source>
        <translation>화면에 맞춰 보여 줍니다. Z 키</translation>
    </message>
    <message>
        <source>Show the force</source>
        <translation>힘 보이기</translation>
    </message>
    <message>
        <source>What is felt</source>
        <translation>만져지는 것을 보여 줍니다</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>다시 실행</translation>
    </message>
    <message>
        <source>Key: Control+Shift+Z</source>
        <translation>Ctrl+Shift+Z 키</translation>
    </message>
    <message>
        <source>Add a face</source>
        <translation>얼굴 추가</translation>
    </message>
    <message>
        <source>One of usual shape, to be put in place</source>
        <translation>보통 모양의 얼굴이며, 자리를 맞춰야 합니다</translation>
    </message>
    <message>
        <source>Discard all changes</source>
        <translation>모든 변경 버리기</translation>
    </message>
    <message>
        <source>The contours as they were opened. Can be undone</source>
        <translation>열었을 때의 윤곽선으로 돌아갑니다. 되돌릴 수 있습니다</translation>
    </message>
    <message>
        <source>Keys on the photograph: Tab and Shift+Tab go from point to point; arrows move it by one pixel, with Shift by ten, with Control by a fifth; Page up and Page down change the feature; A adds a point, Delete deletes it, C turns a corner, M moves the whole feature, F shows the force, plus and minus zoom, 0 shows all, Z this feature, W says where one is.</source>
        <translation>사진에서 쓰는 키: 탭과 Shift+탭은 점 사이를 이동합니다. 화살표 키는 점을 1픽셀씩, Shift와 함께 누르면 10픽셀씩, Ctrl과 함께 누르면 5분의 1픽셀씩 옮깁니다. Page Up과 Page Down은 부위를 바꿉니다. A는 점을 추가하고, Delete는 삭제하고, C는 모서리와 매끄러운 점을 서로 바꾸고, M은 부위 전체를 옮기고, F는 힘을 보여 줍니다. 더하기와 빼기는 확대와 축소, 0은 전체, Z는 이 부위, W는 현재 위치입니다.</translation>
    </message>
</context>
<context>
    <name>MendSurface</name>
    <message>
        <source>Contours</source>
        <translation>윤곽선</translation>
    </message>
    <message>
        <source>Tab goes from point to point. Arrow keys move it by one pixel of the photograph, with Shift by ten, with Control by a fifth. Page up and page down change the feature.</source>
        <translation>탭 키는 점 사이를 이동합니다. 화살표 키는 점을 사진의 1픽셀씩, Shift와 함께 누르면 10픽셀씩, Ctrl과 함께 누르면 5분의 1픽셀씩 옮깁니다. Page Up과 Page Down은 부위를 바꿉니다.</translation>
    </message>
    <message>
        <source>%1 across, %2 down</source>
        <translation>가로 %1, 세로 %2</translation>
    </message>
    <message>
        <source>No photograph yet.</source>
        <translation>아직 사진이 없습니다.</translation>
    </message>
</context>
<context>
    <name>MendWords</name>
    <message>
        <source>Corner %1 of %2</source>
        <translation>모서리 점, %2개 중 %1번째</translation>
    </message>
    <message>
        <source>Point %1 of %2</source>
        <translation>점, %2개 중 %1번째</translation>
    </message>
    <message>
        <source>Bend %1 of %2</source>
        <comment>a control point beside the line</comment>
        <translation>굽힘 점, %2개 중 %1번째</translation>
    </message>
    <message>
        <source>%1 across, %2 down</source>
        <translation>가로 %1, 세로 %2</translation>
    </message>
    <message>
        <source>It feels as the program found it.</source>
        <translation>프로그램이 찾은 것과 똑같이 만져집니다.</translation>
    </message>
    <message>
        <source>A finger will not notice the difference to what the program found.</source>
        <translation>프로그램이 찾은 것과의 차이를 손가락으로는 느낄 수 없습니다.</translation>
    </message>
    <message>
        <source>A finger notices the difference to what the program found on %1 % of the surface; there the force differs by up to %2 N.</source>
        <translation>프로그램이 찾은 것과의 차이가 면의 %1 %에서 손가락에 느껴집니다. 그곳에서 힘의 차이는 최대 %2 N입니다.</translation>
    </message>
</context>
<context>
    <name>NameField</name>
    <message>
        <source>Type, or choose below</source>
        <translation>입력하거나 아래에서 고르세요</translation>
    </message>
</context>
<context>
    <name>NameList</name>
    <message>
        <source>Back</source>
        <translation>뒤로</translation>
    </message>
    <message>
        <source>Key: Backspace</source>
        <translation>백스페이스 키</translation>
    </message>
    <message>
        <source>A name, a place or any word</source>
        <translation>이름, 장소 또는 아무 낱말</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>위로</translation>
    </message>
    <message>
        <source>To the previous row. Key: up arrow</source>
        <translation>이전 줄로 갑니다. 위쪽 화살표 키</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>아래로</translation>
    </message>
    <message>
        <source>To the next row. Key: down arrow</source>
        <translation>다음 줄로 갑니다. 아래쪽 화살표 키</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>선택</translation>
    </message>
    <message>
        <source>The row that was told last. Key: Return</source>
        <translation>마지막으로 읽어 준 줄을 고릅니다. 엔터 키</translation>
    </message>
    <message>
        <source>Letters to spell with</source>
        <translation>글자를 고르는 판</translation>
    </message>
    <message>
        <source>Take the last letter back</source>
        <translation>마지막 글자 지우기</translation>
    </message>
</context>
<context>
    <name>OpenDialog</name>
    <message>
        <source>Open photograph</source>
        <translation>사진 열기</translation>
    </message>
    <message>
        <source>Photographs (%1)</source>
        <translation>사진 (%1)</translation>
    </message>
    <message>
        <source>All files (%1)</source>
        <translation>모든 파일 (%1)</translation>
    </message>
</context>
<context>
    <name>PhotoListPane</name>
    <message>
        <source>Photographs of the album</source>
        <translation>앨범의 사진</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>순서</translation>
    </message>
    <message>
        <source>Newest first</source>
        <translation>최신 사진부터</translation>
    </message>
    <message>
        <source>Check these first</source>
        <translation>확인이 필요한 것부터</translation>
    </message>
    <message numerus="yes">
        <source>Looking at faces, %n photograph(s) left…</source>
        <translation>
            <numerusform>얼굴을 살펴보는 중, 사진 %n장 남음…</numerusform>
        </translation>
    </message>
    <message>
        <source>No photograph is in the album yet.</source>
        <translation>앨범에 아직 사진이 없습니다.</translation>
    </message>
    <message>
        <source>The album has no folder yet. You are asked for one when you import.</source>
        <translation>앨범에 아직 폴더가 없습니다. 사진을 가져올 때 폴더를 묻습니다.</translation>
    </message>
</context>
<context>
    <name>PhotoPane</name>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Left and right arrow: other photographs. Up and down: what is known. Return: recordings.</source>
        <translation>왼쪽과 오른쪽 화살표 키: 다른 사진. 위쪽과 아래쪽 화살표 키: 사진 정보. 엔터 키: 녹음.</translation>
    </message>
    <message>
        <source>Back to the photographs</source>
        <translation>사진 목록으로</translation>
    </message>
    <message>
        <source>The photograph</source>
        <translation>사진</translation>
    </message>
    <message>
        <source>Mend the contours…</source>
        <translation>윤곽선 고치기…</translation>
    </message>
    <message>
        <source>Print a tactile sheet…</source>
        <translation>촉각 인쇄물 만들기…</translation>
    </message>
    <message>
        <source>Delete the photograph</source>
        <translation>사진 삭제</translation>
    </message>
    <message>
        <source>With everything that is its own. Undo brings it back.</source>
        <translation>사진에 딸린 것도 모두 삭제합니다. 되돌리기로 되살릴 수 있습니다.</translation>
    </message>
    <message>
        <source>Choose a photograph to care for it.</source>
        <translation>관리할 사진을 고르세요.</translation>
    </message>
</context>
<context>
    <name>PhotoWords</name>
    <message numerus="yes">
        <source>%n face(s)</source>
        <translation>
            <numerusform>얼굴 %n개</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more face(s)</source>
        <translation>
            <numerusform>다른 얼굴 %n개</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <comment>between who, when and where</comment>
        <translation>, </translation>
    </message>
    <message>
        <source>%1; no recordings yet.</source>
        <translation>%1; 아직 녹음이 없습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%1; %n recording(s).</source>
        <translation>
            <numerusform>%1; 녹음 %n개.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n face(s) without a name.</source>
        <translation>
            <numerusform>이름 없는 얼굴 %n개.</numerusform>
        </translation>
    </message>
    <message>
        <source>Recording %1 of %2: %3, %4.</source>
        <translation>녹음 %2개 중 %1번째: %3, %4.</translation>
    </message>
    <message>
        <source>Place: %1.</source>
        <translation>장소: %1.</translation>
    </message>
    <message>
        <source>Place: %1 degrees north, %2 degrees east.</source>
        <translation>장소: 북위 %1도, 동경 %2도.</translation>
    </message>
    <message>
        <source>Taken: %1.</source>
        <translation>찍은 때: %1.</translation>
    </message>
    <message>
        <source>Keywords: %1.</source>
        <translation>키워드: %1.</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between keywords</comment>
        <translation>, </translation>
    </message>
    <message>
        <source>File: %1.</source>
        <translation>파일: %1.</translation>
    </message>
    <message>
        <source>memo</source>
        <translation>메모</translation>
    </message>
    <message>
        <source>memo by %1</source>
        <translation>%1의 메모</translation>
    </message>
    <message>
        <source>about a person</source>
        <translation>사람에 대하여</translation>
    </message>
    <message>
        <source>about a person, by %1</source>
        <translation>사람에 대하여, 말한 사람 %1</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>%1에 대하여</translation>
    </message>
    <message>
        <source>about %1, by %2</source>
        <translation>%1에 대하여, 말한 사람 %2</translation>
    </message>
    <message>
        <source>about the place</source>
        <translation>장소에 대하여</translation>
    </message>
    <message>
        <source>about the place, by %1</source>
        <translation>장소에 대하여, 말한 사람 %1</translation>
    </message>
    <message>
        <source>story</source>
        <translation>이야기</translation>
    </message>
    <message>
        <source>story by %1</source>
        <translation>%1의 이야기</translation>
    </message>
    <message>
        <source>sounds around the camera</source>
        <translation>카메라 주변 소리</translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s)</source>
        <translation>
            <numerusform>%n시간</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n minute(s)</source>
        <translation>
            <numerusform>%n분</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n second(s)</source>
        <translation>
            <numerusform>%n초</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>the month&apos;s name and the year</comment>
        <translation>%2년 %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>a day and a time</comment>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>PhotosDialog</name>
    <message>
        <source>Import photographs</source>
        <translation>사진 가져오기</translation>
    </message>
    <message>
        <source>Photographs and bundles (%1)</source>
        <translation>사진과 묶음 (%1)</translation>
    </message>
    <message>
        <source>All files (%1)</source>
        <translation>모든 파일 (%1)</translation>
    </message>
</context>
<context>
    <name>PrintPage</name>
    <message>
        <source>Choose the paper and the face, then store the sheet as PDF for a printer or as SVG for a drawing program. Swell paper and embossers raise its black lines and dots.</source>
        <translation>종이와 얼굴을 고른 다음, 인쇄기용 PDF나 그리기 프로그램용 SVG로 인쇄물을 저장하세요. 팽창지나 점자 프린터를 쓰면 검은 선과 점이 도드라집니다.</translation>
    </message>
    <message>
        <source>The sheet, %1</source>
        <translation>인쇄물, %1</translation>
    </message>
    <message>
        <source>No sheet yet</source>
        <translation>아직 인쇄물이 없습니다</translation>
    </message>
    <message>
        <source>No photograph</source>
        <translation>사진 없음</translation>
    </message>
    <message>
        <source>Looking for faces</source>
        <translation>얼굴을 찾는 중</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>종이</translation>
    </message>
    <message>
        <source>Turned by a quarter</source>
        <translation>90도 돌리기</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>누구</translation>
    </message>
    <message>
        <source>Its name in print</source>
        <translation>이름을 글자로도 넣기</translation>
    </message>
    <message>
        <source>Store as PDF</source>
        <translation>PDF로 저장</translation>
    </message>
    <message>
        <source>Store as SVG</source>
        <translation>SVG로 저장</translation>
    </message>
</context>
<context>
    <name>RecordingsPart</name>
    <message>
        <source>Recordings</source>
        <translation>녹음</translation>
    </message>
    <message>
        <source>No recording yet.</source>
        <translation>아직 녹음이 없습니다.</translation>
    </message>
    <message>
        <source>Chosen: %1</source>
        <translation>선택됨: %1</translation>
    </message>
    <message>
        <source>Stop playing</source>
        <translation>재생 멈춤</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>재생</translation>
    </message>
    <message>
        <source>Play earlier</source>
        <translation>더 먼저 재생</translation>
    </message>
    <message>
        <source>Moves it up in the list.</source>
        <translation>목록에서 위로 옮깁니다.</translation>
    </message>
    <message>
        <source>Play later</source>
        <translation>더 나중에 재생</translation>
    </message>
    <message>
        <source>Moves it down in the list.</source>
        <translation>목록에서 아래로 옮깁니다.</translation>
    </message>
    <message>
        <source>Record again</source>
        <translation>다시 녹음</translation>
    </message>
    <message>
        <source>The old one goes to the trash when the new one is kept.</source>
        <translation>새 녹음을 보관하면 이전 녹음은 휴지통으로 갑니다.</translation>
    </message>
    <message>
        <source>Close the label</source>
        <translation>녹음 정보 닫기</translation>
    </message>
    <message>
        <source>Label…</source>
        <translation>녹음 정보…</translation>
    </message>
    <message>
        <source>Kind, person, speaker and language.</source>
        <translation>종류, 대상, 말하는 사람, 언어.</translation>
    </message>
    <message>
        <source>Delete the recording</source>
        <translation>녹음 삭제</translation>
    </message>
    <message>
        <source>Undo brings it back.</source>
        <translation>되돌리기로 되살릴 수 있습니다.</translation>
    </message>
</context>
<context>
    <name>Sentence</name>
    <message>
        <source>&quot;%1&quot; cannot be added to a face; brows, nose and irises can.</source>
        <translation>“%1”: 얼굴에 더할 수 없습니다. 눈썹, 코, 홍채는 더할 수 있습니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be changed: %2</source>
        <translation>“%1”: 바꿀 수 없습니다. %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be moved: %2</source>
        <translation>“%1”: 옮길 수 없습니다. %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read.</source>
        <translation>“%1”: 읽을 수 없습니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be renamed: %2</source>
        <translation>“%1”: 이름을 바꿀 수 없습니다. %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be restored and stays in the trash: %2</source>
        <translation>“%1”: 되살릴 수 없어 휴지통에 그대로 둡니다. %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be restored, because another file has its place now. Move that one away first.</source>
        <translation>“%1”: 그 자리에 다른 파일이 있어 되살릴 수 없습니다. 먼저 그 파일을 옮기세요.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be taken in: %2</source>
        <translation>“%1”: 가져올 수 없습니다. %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be trimmed: %2</source>
        <translation>“%1”: 자를 수 없습니다. %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be trimmed: the part must begin before it ends.</source>
        <translation>“%1”: 자를 수 없습니다. 시작이 끝보다 앞에 있어야 합니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be used: %2</source>
        <translation>“%1”: 쓸 수 없습니다. %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; changed meanwhile.</source>
        <translation>“%1”: 그사이 내용이 바뀌었습니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a folder, not a file.</source>
        <translation>“%1”: 파일이 아니라 폴더입니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a folder.</source>
        <translation>“%1”: 폴더입니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a file.</source>
        <translation>“%1”: 파일이 아닙니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a folder in the album.</source>
        <translation>“%1”: 앨범 안의 폴더가 아닙니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not in the album &quot;%2&quot;.</source>
        <translation>“%1”: 앨범 “%2”에 없습니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already, so nothing was moved.</source>
        <translation>“%1”: 이미 있어서 아무것도 옮기지 않았습니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there, so it stays on the list.</source>
        <translation>“%1”: 파일이 있으므로 목록에 남겨 둡니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not deleted, because it is not in the album &quot;%2&quot;.</source>
        <translation>“%1”: 앨범 “%2”에 없어서 지우지 않았습니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not imported: %2</source>
        <translation>“%1”: 가져오지 못했습니다. %2</translation>
    </message>
    <message>
        <source>%1 Bring the photograph back first, then its recording.</source>
        <translation>%1 먼저 사진을 되살린 다음 녹음을 되살리세요.</translation>
    </message>
    <message>
        <source>%1 It stays where it is.</source>
        <translation>%1 있던 곳에 그대로 둡니다.</translation>
    </message>
    <message>
        <source>%1 It was left as it is.</source>
        <translation>%1 그대로 두었습니다.</translation>
    </message>
    <message>
        <source>%1 Some photographs kept the new name: %2</source>
        <translation>%1 일부 사진에는 새 이름이 남았습니다. %2</translation>
    </message>
    <message>
        <source>%1 became %2</source>
        <translation>이름이 %1에서 %2(으)로 바뀜</translation>
    </message>
    <message>
        <source>%1 cannot be used: %2</source>
        <translation>%1: 쓸 수 없습니다. %2</translation>
    </message>
    <message>
        <source>%1 has a transform that cannot be read: &quot;%2&quot;.</source>
        <translation>%1: 변환을 읽을 수 없습니다. “%2”.</translation>
    </message>
    <message>
        <source>%1 in &quot;%2&quot;</source>
        <translation>%1(“%2”)</translation>
    </message>
    <message>
        <source>%1 is being made.</source>
        <translation>%1: 만드는 중입니다.</translation>
    </message>
    <message>
        <source>%1 is moved by its style, which is not understood; give it a transform attribute instead.</source>
        <translation>%1: 스타일로 옮긴 것은 이해하지 못합니다. 대신 transform 속성을 쓰세요.</translation>
    </message>
    <message>
        <source>%1 is not from %2 to %3.</source>
        <translation>%1: %2에서 %3까지가 아닙니다.</translation>
    </message>
    <message>
        <source>%1 reaches beyond what can be computed with.</source>
        <translation>%1: 계산할 수 있는 범위를 벗어납니다.</translation>
    </message>
    <message>
        <source>%1 was &quot;%2&quot; in another copy; it is &quot;%3&quot; now.</source>
        <translation>%1: 다른 사본에는 “%2”였습니다. 지금은 “%3”입니다.</translation>
    </message>
    <message>
        <source>%1 was added</source>
        <translation>%1 추가</translation>
    </message>
    <message>
        <source>%1 was deleted</source>
        <translation>%1 삭제</translation>
    </message>
    <message>
        <source>%1 was described</source>
        <translation>%1 설명 변경</translation>
    </message>
    <message>
        <source>%1 was labelled</source>
        <translation>%1 정보 변경</translation>
    </message>
    <message>
        <source>%1 was not finished and cannot be repaired: %2</source>
        <translation>%1: 끝나지 않았고 고칠 수 없습니다. %2</translation>
    </message>
    <message>
        <source>%1 was not finished and held no sound.</source>
        <translation>%1: 끝나지 않았고 소리가 들어 있지 않았습니다.</translation>
    </message>
    <message>
        <source>%1 was not finished; what was recorded is in &quot;%2&quot;.</source>
        <translation>%1: 끝나지 않았습니다. 녹음된 것은 “%2”에 있습니다.</translation>
    </message>
    <message>
        <source>%1 was trimmed</source>
        <translation>%1 자르기</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>A motor of the force pad took too much current. See that nothing blocks the knob.</source>
        <translation>힘 패드의 모터에 전류가 너무 많이 흘렀습니다. 손잡이를 막는 것이 없는지 살펴보세요.</translation>
    </message>
    <message>
        <source>A person needs a name before it can be recorded.</source>
        <translation>이름을 녹음하려면 먼저 사람의 이름이 있어야 합니다.</translation>
    </message>
    <message>
        <source>A person needs a name, and another one than before.</source>
        <translation>이름이 있어야 하며, 전과 다른 이름이어야 합니다.</translation>
    </message>
    <message>
        <source>A picture and the touch surface both need a width and a height above zero.</source>
        <translation>사진과 터치면 모두 너비와 높이가 0보다 커야 합니다.</translation>
    </message>
    <message>
        <source>A recording is listed as %1, which is no file name; it is left out.</source>
        <translation>녹음 목록의 %1: 파일 이름이 아니어서 뺐습니다.</translation>
    </message>
    <message>
        <source>A tactile sheet is written as .pdf or .svg, not as &quot;%1&quot;.</source>
        <translation>촉각 인쇄물은 .pdf나 .svg로 저장합니다. “%1”(으)로는 저장할 수 없습니다.</translation>
    </message>
    <message>
        <source>Another driver holds the %1. Remove the driver that its maker installed and start this computer again.</source>
        <translation>다른 드라이버가 장치를 쓰고 있습니다: %1. 제조사가 설치한 드라이버를 지우고 컴퓨터를 다시 시작하세요.</translation>
    </message>
    <message>
        <source>Another driver of the system holds the %1 and does not let go of it. Unplug the device, unload that driver and plug the device in again.</source>
        <translation>시스템의 다른 드라이버가 장치를 놓아주지 않습니다: %1. 장치를 뽑고 그 드라이버를 내린 다음 다시 꽂으세요.</translation>
    </message>
    <message>
        <source>Another driver of the system holds the %1. Unplug the device and plug it in again; if that does not help, its kernel must have the hidraw driver.</source>
        <translation>시스템의 다른 드라이버가 장치를 쓰고 있습니다: %1. 장치를 뽑았다가 다시 꽂으세요. 그래도 안 되면 커널에 hidraw 드라이버가 있어야 합니다.</translation>
    </message>
    <message>
        <source>Another program is at work on &quot;%1&quot;; try again.</source>
        <translation>다른 프로그램이 “%1”에서 작업하고 있습니다. 다시 해 보세요.</translation>
    </message>
    <message>
        <source>Another program uses the %1. Close that program and try again.</source>
        <translation>다른 프로그램이 장치를 쓰고 있습니다: %1. 그 프로그램을 닫고 다시 해 보세요.</translation>
    </message>
    <message>
        <source>Calibration needs at least three marks that do not lie on one line; touch more marks.</source>
        <translation>보정하려면 한 줄에 있지 않은 표시가 적어도 세 개 있어야 합니다. 표시를 더 만지세요.</translation>
    </message>
    <message>
        <source>Hysteresis and blending are two answers to the same jump; choose one of them.</source>
        <translation>히스테리시스와 블렌딩은 같은 튐을 다루는 두 방법입니다. 하나만 고르세요.</translation>
    </message>
    <message>
        <source>Hysteresis, blending and corner cue belong to the exact law, not to the published one.</source>
        <translation>히스테리시스, 블렌딩, 모서리 신호는 정확한 법칙에만 있고 발표된 법칙에는 없습니다.</translation>
    </message>
    <message>
        <source>It is damaged; only the first %1 of %2 could be read.</source>
        <translation>파일이 손상되어 처음 %1만 읽을 수 있었습니다. 전체는 %2입니다.</translation>
    </message>
    <message>
        <source>It names a file in a way that TouchPhoto does not write.</source>
        <translation>TouchPhoto가 쓰지 않는 방식으로 파일 이름이 적혀 있습니다.</translation>
    </message>
    <message>
        <source>No face was found in this picture.</source>
        <translation>이 사진에서 얼굴을 찾지 못했습니다.</translation>
    </message>
    <message>
        <source>Nothing was deleted, because the trash cannot be made: %1</source>
        <translation>휴지통을 만들 수 없어 아무것도 지우지 않았습니다. %1</translation>
    </message>
    <message>
        <source>Nothing was deleted, because the trash cannot be written to: %1</source>
        <translation>휴지통에 쓸 수 없어 아무것도 지우지 않았습니다. %1</translation>
    </message>
    <message>
        <source>Nothing was deleted: %1</source>
        <translation>아무것도 지우지 않았습니다. %1</translation>
    </message>
    <message>
        <source>Nothing was named that could be deleted.</source>
        <translation>지울 것을 고르지 않았습니다.</translation>
    </message>
    <message>
        <source>Pictures other than JPEG need the library %1 (Debian: libopencv-imgcodecs406), which is not here: install it or save the picture as JPEG.</source>
        <translation>JPEG가 아닌 사진에는 라이브러리 %1(데비안: libopencv-imgcodecs406)이 필요한데 여기에 없습니다. 설치하거나 사진을 JPEG로 저장하세요.</translation>
    </message>
    <message>
        <source>Qt&apos;s driver for SQLite is not installed; without it there is no album. On Debian it is the package libqt6sql6-sqlite.</source>
        <translation>SQLite용 Qt 드라이버가 없어 앨범을 쓸 수 없습니다. 데비안에서는 libqt6sql6-sqlite 패키지입니다.</translation>
    </message>
    <message>
        <source>Stiffness and range of the guidance must both be numbers above zero.</source>
        <translation>안내의 강성과 범위는 모두 0보다 큰 숫자여야 합니다.</translation>
    </message>
    <message>
        <source>The %1 &quot;%2&quot;</source>
        <translation>%1 요소 “%2”</translation>
    </message>
    <message>
        <source>The %1 could not be opened. Unplug it, plug it in again and try once more.</source>
        <translation>장치를 열 수 없습니다: %1. 뽑았다가 다시 꽂고 한 번 더 해 보세요.</translation>
    </message>
    <message>
        <source>The %1 file is damaged.</source>
        <translation>%1 파일이 손상되었습니다.</translation>
    </message>
    <message>
        <source>The %1 has the wrong driver. In the Device Manager choose Update driver, then &quot;USB Input Device&quot;.</source>
        <translation>장치의 드라이버가 맞지 않습니다: %1. 장치 관리자에서 ‘드라이버 업데이트’를 고른 다음 ‘USB 입력 장치’를 고르세요.</translation>
    </message>
    <message>
        <source>The %1 has the wrong driver. In the Device Manager choose Update driver, then &quot;WinUsb Device&quot;.</source>
        <translation>장치의 드라이버가 맞지 않습니다: %1. 장치 관리자에서 ‘드라이버 업데이트’를 고른 다음 ‘WinUsb 장치’를 고르세요.</translation>
    </message>
    <message>
        <source>The %1 may be covered, so its contour may be wrong.</source>
        <translation>%1이 가려진 듯하여 윤곽선이 틀릴 수 있습니다.</translation>
    </message>
    <message>
        <source>The %1 was unplugged. Plug it in again.</source>
        <translation>장치가 뽑혔습니다: %1. 다시 꽂으세요.</translation>
    </message>
    <message>
        <source>The %1 without an id</source>
        <translation>id가 없는 %1 요소</translation>
    </message>
    <message>
        <source>The JPEG file is cut short: a part of the picture is missing.</source>
        <translation>JPEG 파일이 중간에 끊겨 사진의 일부가 없습니다.</translation>
    </message>
    <message>
        <source>The JPEG file is damaged.</source>
        <translation>JPEG 파일이 손상되었습니다.</translation>
    </message>
    <message>
        <source>The PNG file is cut short: a part of the picture is missing.</source>
        <translation>PNG 파일이 중간에 끊겨 사진의 일부가 없습니다.</translation>
    </message>
    <message>
        <source>The PNG file is damaged.</source>
        <translation>PNG 파일이 손상되었습니다.</translation>
    </message>
    <message>
        <source>The WebP file is cut short: a part of the picture is missing.</source>
        <translation>WebP 파일이 중간에 끊겨 사진의 일부가 없습니다.</translation>
    </message>
    <message>
        <source>The album&apos;s index %1; it was set aside as &quot;%2&quot; and is made anew. The photographs are not touched by this.</source>
        <translation>앨범 색인이 %1. 그 색인은 “%2”(으)로 치워 두고 새로 만듭니다. 사진은 그대로입니다.</translation>
    </message>
    <message>
        <source>The album&apos;s index cannot be kept in &quot;%1&quot;; it is held in memory and made anew at every start: %2</source>
        <translation>앨범 색인을 “%1”에 둘 수 없어 메모리에 두고 시작할 때마다 새로 만듭니다. %2</translation>
    </message>
    <message>
        <source>The album&apos;s index cannot be made: %1.</source>
        <translation>앨범 색인을 만들 수 없습니다: %1.</translation>
    </message>
    <message>
        <source>The album&apos;s index cannot be used: %1.</source>
        <translation>앨범 색인을 쓸 수 없습니다: %1.</translation>
    </message>
    <message>
        <source>The album&apos;s index cannot grow: the disk is full.</source>
        <translation>디스크가 가득 차서 앨범 색인이 커질 수 없습니다.</translation>
    </message>
    <message>
        <source>The album&apos;s index is damaged; it is made anew when the album is opened next. The photographs are not touched by this.</source>
        <translation>앨범 색인이 손상되었습니다. 앨범을 다음에 열 때 새로 만듭니다. 사진은 그대로입니다.</translation>
    </message>
    <message>
        <source>The braille table %1 was not found; names cannot be written in braille. Install the package liblouis-data.</source>
        <translation>점자표 %1을(를) 찾지 못해 이름을 점자로 쓸 수 없습니다. liblouis-data 패키지를 설치하세요.</translation>
    </message>
    <message>
        <source>The bundle &quot;%1&quot; cannot be used: %2</source>
        <translation>묶음 “%1”: 쓸 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The bundle &quot;%1&quot; was not written: %2</source>
        <translation>묶음 “%1”: 쓰지 못했습니다. %2</translation>
    </message>
    <message>
        <source>The bundle cannot be unpacked, because &quot;%1&quot; is not empty.</source>
        <translation>“%1” 폴더가 비어 있지 않아 묶음을 풀 수 없습니다.</translation>
    </message>
    <message>
        <source>The bundle cannot be unpacked: %1</source>
        <translation>묶음을 풀 수 없습니다. %1</translation>
    </message>
    <message>
        <source>The calibration misses its marks by %1 mm, more than the %2 mm allowed; touch them again.</source>
        <translation>보정이 표시에서 %1 mm 벗어났습니다. 허용은 %2 mm입니다. 다시 만지세요.</translation>
    </message>
    <message>
        <source>The conflict copy &quot;%1&quot; cannot be read: %2</source>
        <translation>충돌 사본 “%1”: 읽을 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The conflict copy &quot;%1&quot; could not be moved to the trash: %2</source>
        <translation>충돌 사본 “%1”: 휴지통으로 옮길 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The date &quot;%1&quot; is in no calendar and is left out.</source>
        <translation>날짜 “%1”: 달력에 없는 날짜라서 뺐습니다.</translation>
    </message>
    <message>
        <source>The description</source>
        <translation>설명</translation>
    </message>
    <message>
        <source>The device was switched off, because it no longer answers. Check its cable and start it again.</source>
        <translation>장치가 더는 응답하지 않아 껐습니다. 케이블을 확인하고 다시 켜세요.</translation>
    </message>
    <message>
        <source>The device was switched off, because this computer stood still. Start it again when you are ready.</source>
        <translation>컴퓨터가 멈추어 장치를 껐습니다. 준비가 되면 다시 켜세요.</translation>
    </message>
    <message>
        <source>The device with a force pad&apos;s ids does not answer like a force pad. Unplug it and plug it in again; if it is no force pad, choose another device.</source>
        <translation>힘 패드의 식별 번호를 가진 장치가 힘 패드처럼 응답하지 않습니다. 뽑았다가 다시 꽂으세요. 힘 패드가 아니면 다른 장치를 고르세요.</translation>
    </message>
    <message>
        <source>The drawing cannot be saved as &quot;%1&quot;: %2</source>
        <translation>그림을 “%1”(으)로 저장할 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The drawing cannot be saved: it needs a width and a height larger than zero.</source>
        <translation>그림의 너비와 높이가 0보다 커야 저장할 수 있습니다.</translation>
    </message>
    <message>
        <source>The drawing cannot be saved: there is not enough memory for it.</source>
        <translation>메모리가 모자라 그림을 저장할 수 없습니다.</translation>
    </message>
    <message>
        <source>The drawing could not be read: there is not enough memory for it.</source>
        <translation>메모리가 모자라 그림을 읽지 못했습니다.</translation>
    </message>
    <message>
        <source>The drawing does not say how large it is; give it a width and a height, or a viewBox.</source>
        <translation>그림의 크기를 알 수 없습니다. 너비와 높이 또는 viewBox를 넣으세요.</translation>
    </message>
    <message>
        <source>The drawing has more elements than a sheet of contours may have.</source>
        <translation>그림에 윤곽선 그림이 가질 수 있는 것보다 많은 요소가 있습니다.</translation>
    </message>
    <message>
        <source>The drawing has more lines than a sheet of contours may have.</source>
        <translation>그림에 윤곽선 그림이 가질 수 있는 것보다 많은 선이 있습니다.</translation>
    </message>
    <message>
        <source>The drawing is larger than 64 MB; that is more than a sheet of contours may be.</source>
        <translation>그림이 64 MB보다 커서 윤곽선 그림으로 쓸 수 없습니다.</translation>
    </message>
    <message>
        <source>The drawing&apos;s %1 &quot;%2&quot; is not a length in mm, cm, in, pt, pc or px.</source>
        <translation>그림의 %1 값 “%2”: mm, cm, in, pt, pc, px로 된 길이가 아닙니다.</translation>
    </message>
    <message>
        <source>The drawing&apos;s %1 is %2, but it must be larger than zero.</source>
        <translation>그림의 %1 값이 %2입니다. 0보다 커야 합니다.</translation>
    </message>
    <message>
        <source>The drawing&apos;s size is beyond what can be computed with.</source>
        <translation>그림이 계산할 수 없을 만큼 큽니다.</translation>
    </message>
    <message>
        <source>The drawing&apos;s viewBox &quot;%1&quot; is not four numbers with a width and a height larger than zero.</source>
        <translation>그림의 viewBox “%1”: 너비와 높이가 0보다 큰 숫자 네 개가 아닙니다.</translation>
    </message>
    <message>
        <source>The edge of the %1 is faint, so its contour may be wrong.</source>
        <translation>%1의 경계가 흐려 윤곽선이 틀릴 수 있습니다.</translation>
    </message>
    <message>
        <source>The face is %1, so the contour of the %2 may be wrong.</source>
        <translation>얼굴이 %1 %2의 윤곽선이 틀릴 수 있습니다.</translation>
    </message>
    <message>
        <source>The face is cut off at the %1 of the picture.</source>
        <translation>얼굴이 사진의 %1에서 잘려 있습니다.</translation>
    </message>
    <message>
        <source>The face is only %1 pixels wide, too small for its contours to be exact.</source>
        <translation>얼굴의 너비가 %1픽셀뿐이라 윤곽선이 정확하기에는 너무 작습니다.</translation>
    </message>
    <message>
        <source>The face of &quot;%1&quot; lies outside the photograph.</source>
        <translation>“%1”의 얼굴이 사진 밖에 있습니다.</translation>
    </message>
    <message>
        <source>The faces were marked on a picture of another shape, so their places may be wrong.</source>
        <translation>얼굴이 모양이 다른 사진에 표시되어 있어 자리가 틀릴 수 있습니다.</translation>
    </message>
    <message>
        <source>The file &quot;%1&quot; cannot be opened; you may not be allowed to read it.</source>
        <translation>파일 “%1”: 열 수 없습니다. 읽을 권한이 없을 수 있습니다.</translation>
    </message>
    <message>
        <source>The file &quot;%1&quot; cannot be read to its end.</source>
        <translation>파일 “%1”: 끝까지 읽을 수 없습니다.</translation>
    </message>
    <message>
        <source>The file &quot;%1&quot; cannot be read.</source>
        <translation>파일 “%1”: 읽을 수 없습니다.</translation>
    </message>
    <message>
        <source>The file &quot;%1&quot; could not be read: there is not enough memory for it.</source>
        <translation>파일 “%1”: 메모리가 모자라 읽지 못했습니다.</translation>
    </message>
    <message>
        <source>The file &quot;%1&quot; is called a photograph, but is none.</source>
        <translation>파일 “%1”: 사진 이름이지만 사진이 아닙니다.</translation>
    </message>
    <message>
        <source>The file &quot;%1&quot; is in a folder that you are not allowed to open.</source>
        <translation>파일 “%1”: 열 권한이 없는 폴더에 있습니다.</translation>
    </message>
    <message>
        <source>The file &quot;%1&quot; is larger than %2 MB; that is more than such a file may be.</source>
        <translation>파일 “%1”: %2 MB보다 큽니다. 이런 파일로는 너무 큽니다.</translation>
    </message>
    <message>
        <source>The file cannot be read.</source>
        <translation>파일을 읽을 수 없습니다.</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>파일이 비어 있습니다.</translation>
    </message>
    <message>
        <source>The file is not a picture of a kind that can be read.</source>
        <translation>읽을 수 있는 종류의 사진이 아닙니다.</translation>
    </message>
    <message>
        <source>The file is too large to be a photograph: more than 2 gigabytes.</source>
        <translation>사진이라기에는 파일이 너무 큽니다. 2기가바이트가 넘습니다.</translation>
    </message>
    <message>
        <source>The fingerprint of the photograph</source>
        <translation>사진의 지문값</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be made: %2</source>
        <translation>폴더 “%1”: 만들 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be read: %2</source>
        <translation>폴더 “%1”: 읽을 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; is not there.</source>
        <translation>폴더 “%1”: 없습니다.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; may not be opened by you.</source>
        <translation>폴더 “%1”: 열 권한이 없습니다.</translation>
    </message>
    <message>
        <source>The force is off for a moment, because this computer was too busy to guide the finger.</source>
        <translation>컴퓨터가 너무 바빠 손가락을 이끌 수 없어서 힘이 잠시 꺼졌습니다.</translation>
    </message>
    <message>
        <source>The force is off, because the device does not say where the finger is.</source>
        <translation>장치가 손가락의 위치를 알려 주지 않아 힘이 꺼졌습니다.</translation>
    </message>
    <message>
        <source>The force is off, because the device has switched its motors off to be safe. It comes back when the device is ready.</source>
        <translation>장치가 안전을 위해 모터를 꺼서 힘이 꺼졌습니다. 장치가 준비되면 다시 켜집니다.</translation>
    </message>
    <message>
        <source>The force is off, because the finger is outside the area that the device reaches. Move it back.</source>
        <translation>손가락이 장치가 닿는 범위 밖에 있어 힘이 꺼졌습니다. 다시 안으로 옮기세요.</translation>
    </message>
    <message>
        <source>The force is off, because the finger moves too fast. Move slowly and it comes back.</source>
        <translation>손가락이 너무 빨리 움직여 힘이 꺼졌습니다. 천천히 움직이면 다시 켜집니다.</translation>
    </message>
    <message>
        <source>The force pad %1 tells of itself what cannot be: %2. It needs another firmware.</source>
        <translation>힘 패드 %1에 있을 수 없는 값이 있습니다: %2. 다른 펌웨어가 필요합니다.</translation>
    </message>
    <message>
        <source>The force pad could not be homed. See that it is plugged in, and try again.</source>
        <translation>힘 패드의 기준점을 잡지 못했습니다. 꽂혀 있는지 보고 다시 해 보세요.</translation>
    </message>
    <message>
        <source>The force pad did not say which places it reaches. Unplug it and plug it in again.</source>
        <translation>힘 패드가 닿는 범위를 알려 주지 않았습니다. 뽑았다가 다시 꽂으세요.</translation>
    </message>
    <message>
        <source>The force pad does not know where its knob is. Put the knob on its mark and home the pad.</source>
        <translation>힘 패드가 손잡이의 위치를 모릅니다. 손잡이를 표시에 놓고 기준점을 잡으세요.</translation>
    </message>
    <message>
        <source>The force pad heard nothing from this computer for a moment and switched its motors off.</source>
        <translation>힘 패드가 잠시 컴퓨터에서 아무것도 받지 못해 모터를 껐습니다.</translation>
    </message>
    <message>
        <source>The force pad&apos;s encoders contradict each other: a cable is slack, or one has slipped. Put the knob on its mark and home the pad.</source>
        <translation>힘 패드의 센서가 서로 맞지 않습니다. 줄이 느슨하거나 센서가 밀렸습니다. 손잡이를 표시에 놓고 기준점을 잡으세요.</translation>
    </message>
    <message>
        <source>The force pad&apos;s motors are off.</source>
        <translation>힘 패드의 모터가 꺼져 있습니다.</translation>
    </message>
    <message>
        <source>The force pad&apos;s motors are too hot. It goes on by itself when they have cooled.</source>
        <translation>힘 패드의 모터가 너무 뜨겁습니다. 식으면 저절로 다시 움직입니다.</translation>
    </message>
    <message>
        <source>The force was switched off for a moment, because a measurement was not a number.</source>
        <translation>측정값이 숫자가 아니어서 힘을 잠시 껐습니다.</translation>
    </message>
    <message>
        <source>The import cannot begin: %1</source>
        <translation>가져오기를 시작할 수 없습니다. %1</translation>
    </message>
    <message>
        <source>The import ended, because the computer reports: %1</source>
        <translation>컴퓨터의 알림으로 가져오기가 끝났습니다: %1</translation>
    </message>
    <message>
        <source>The import&apos;s list cannot be removed: %1</source>
        <translation>가져오기 목록을 지울 수 없습니다. %1</translation>
    </message>
    <message>
        <source>The kind %1</source>
        <translation>%1의 종류</translation>
    </message>
    <message>
        <source>The language %1</source>
        <translation>%1의 언어</translation>
    </message>
    <message>
        <source>The list of the import &quot;%1&quot; cannot be read; import its folder again, nothing comes twice.</source>
        <translation>가져오기 “%1”의 목록을 읽을 수 없습니다. 폴더를 다시 가져오세요. 두 번 들어오는 것은 없습니다.</translation>
    </message>
    <message>
        <source>The list of what was deleted in &quot;%1&quot; cannot be read; its files are still there.</source>
        <translation>“%1”의 삭제 목록을 읽을 수 없습니다. 파일은 그대로 있습니다.</translation>
    </message>
    <message>
        <source>The map between two frames cannot be turned round, because it flattens the plane to a line.</source>
        <translation>두 좌표계의 변환이 평면을 선으로 눌러 거꾸로 할 수 없습니다.</translation>
    </message>
    <message>
        <source>The mended contours &quot;%1&quot; cannot be taken away: %2</source>
        <translation>고친 윤곽선 “%1”: 치울 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The mended contours cannot be saved as &quot;%1&quot;: %2</source>
        <translation>고친 윤곽선을 “%1”(으)로 저장할 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The mended contours in %1 cannot be used, and the program&apos;s own are taken: %2</source>
        <translation>%1: 고친 윤곽선을 쓸 수 없어 프로그램의 윤곽선을 씁니다. %2</translation>
    </message>
    <message>
        <source>The mended contours in %1 cannot be used: %2</source>
        <translation>%1: 고친 윤곽선을 쓸 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The name cannot be kept: %1</source>
        <translation>이름을 보관할 수 없습니다. %1</translation>
    </message>
    <message>
        <source>The name of a face</source>
        <translation>얼굴의 이름</translation>
    </message>
    <message>
        <source>The nets that find faces cannot be used: %1</source>
        <translation>얼굴을 찾는 신경망을 쓸 수 없습니다: %1</translation>
    </message>
    <message>
        <source>The person %1</source>
        <translation>%1의 사람</translation>
    </message>
    <message>
        <source>The photograph &quot;%1&quot; cannot be read: %2</source>
        <translation>사진 “%1”: 읽을 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The photograph &quot;%1&quot; cannot be read: you are not allowed to.</source>
        <translation>사진 “%1”: 읽을 권한이 없습니다.</translation>
    </message>
    <message>
        <source>The photograph &quot;%1&quot; is now &quot;%2&quot;, but what belongs to it stayed behind: %3</source>
        <translation>사진 “%1”: 이제 “%2”에 있지만 딸린 것은 남아 있습니다. %3</translation>
    </message>
    <message>
        <source>The photograph &quot;%1&quot; says more of itself than any program writes; it was not read.</source>
        <translation>사진 “%1”: 어떤 프로그램이 쓰는 것보다 정보가 많아 읽지 않았습니다.</translation>
    </message>
    <message>
        <source>The photograph&apos;s EXIF is damaged.</source>
        <translation>사진의 EXIF가 손상되었습니다.</translation>
    </message>
    <message>
        <source>The photograph&apos;s IPTC is damaged.</source>
        <translation>사진의 IPTC가 손상되었습니다.</translation>
    </message>
    <message>
        <source>The photograph&apos;s XMP cannot be read: %1</source>
        <translation>사진의 XMP를 읽을 수 없습니다. %1</translation>
    </message>
    <message>
        <source>The photograph&apos;s XMP is damaged.</source>
        <translation>사진의 XMP가 손상되었습니다.</translation>
    </message>
    <message>
        <source>The photograph&apos;s own metadata is damaged; what could be read of it counts.</source>
        <translation>사진에 든 정보가 손상되었습니다. 읽을 수 있는 것만 씁니다.</translation>
    </message>
    <message>
        <source>The picture cannot be decoded.</source>
        <translation>사진을 해독할 수 없습니다.</translation>
    </message>
    <message>
        <source>The picture is empty.</source>
        <translation>사진이 비어 있습니다.</translation>
    </message>
    <message>
        <source>The picture is not in 8-bit colour.</source>
        <translation>사진이 8비트 색상이 아닙니다.</translation>
    </message>
    <message>
        <source>The picture is only %1 × %2 pixels, too small to show a face.</source>
        <translation>사진이 %1 × %2픽셀뿐이라 얼굴을 보여 주기에는 너무 작습니다.</translation>
    </message>
    <message>
        <source>The picture is too large: %1 × %2 pixels, where at most %3 million can be read.</source>
        <translation>사진이 너무 큽니다: %1 × %2픽셀. 최대 %3메가픽셀까지 읽을 수 있습니다.</translation>
    </message>
    <message>
        <source>The picture or the touch surface is too large or too small to be computed with.</source>
        <translation>사진이나 터치면이 계산하기에 너무 크거나 작습니다.</translation>
    </message>
    <message>
        <source>The place of %1 makes no sense and is left out.</source>
        <translation>%1: 자리가 맞지 않아 뺐습니다.</translation>
    </message>
    <message>
        <source>The place of the face must lie in the picture, 0 to 1 from its left and upper edge.</source>
        <translation>얼굴의 자리는 사진 안, 왼쪽과 위쪽 가장자리에서 0부터 1 사이여야 합니다.</translation>
    </message>
    <message>
        <source>The position is no place on Earth and is left out.</source>
        <translation>지구에 없는 위치라서 뺐습니다.</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot;</source>
        <translation>녹음 “%1”</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; can only be played from its beginning.</source>
        <translation>녹음 “%1”: 처음부터만 재생할 수 있습니다.</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; cannot be listed twice.</source>
        <translation>녹음 “%1”: 목록에 두 번 넣을 수 없습니다.</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; cannot be listed: that is no name of a file that XML can hold.</source>
        <translation>녹음 “%1”: XML에 담을 수 없는 파일 이름이라 목록에 넣을 수 없습니다.</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; cannot be played: %2</source>
        <translation>녹음 “%1”: 재생할 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; cannot be used: %2</source>
        <translation>녹음 “%1”: 쓸 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; is kept, but the photograph&apos;s list could not be written: %2</source>
        <translation>녹음 “%1”: 보관했지만 사진의 목록에 쓰지 못했습니다. %2</translation>
    </message>
    <message>
        <source>The recording %1 could not be written. Choose a folder that you may write to.</source>
        <translation>기록 %1: 쓰지 못했습니다. 쓸 수 있는 폴더를 고르세요.</translation>
    </message>
    <message>
        <source>The recording %1 is listed twice; the first counts.</source>
        <translation>녹음 %1: 목록에 두 번 있어 첫 번째만 씁니다.</translation>
    </message>
    <message>
        <source>The replay was stopped.</source>
        <translation>재현을 멈췄습니다.</translation>
    </message>
    <message>
        <source>The scene has no line that can be felt.</source>
        <translation>만져 볼 수 있는 선이 없습니다.</translation>
    </message>
    <message>
        <source>The search for faces failed (%1).</source>
        <translation>얼굴 찾기에 실패했습니다(%1).</translation>
    </message>
    <message>
        <source>The search for faces was stopped.</source>
        <translation>얼굴 찾기를 멈췄습니다.</translation>
    </message>
    <message>
        <source>The short description</source>
        <translation>짧은 설명</translation>
    </message>
    <message>
        <source>The sidecar &quot;%1&quot; cannot be read: %2</source>
        <translation>사이드카 “%1”: 읽을 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The sidecar &quot;%1&quot; could not be written: %2</source>
        <translation>사이드카 “%1”: 쓰지 못했습니다. %2</translation>
    </message>
    <message>
        <source>The sidecar of &quot;%1&quot; could not be written: another program is busy there.</source>
        <translation>“%1”의 사이드카: 다른 프로그램이 쓰고 있어 쓰지 못했습니다.</translation>
    </message>
    <message>
        <source>The sidecar of &quot;%1&quot; was changed in two places at once; it holds both now, and the copy &quot;%2&quot; is in the trash.</source>
        <translation>“%1”의 사이드카: 두 곳에서 동시에 바뀌었습니다. 이제 둘 다 들어 있고, 사본 “%2”은(는) 휴지통에 있습니다.</translation>
    </message>
    <message>
        <source>The sound of &quot;%1&quot; is not whole. %2</source>
        <translation>“%1”의 소리가 온전하지 않습니다. %2</translation>
    </message>
    <message>
        <source>The sound of the video &quot;%1&quot; does not come along: %2</source>
        <translation>동영상 “%1”의 소리는 함께 오지 않습니다. %2</translation>
    </message>
    <message>
        <source>The sound of the video in &quot;%1&quot; does not come along: %2</source>
        <translation>“%1” 안 동영상의 소리는 함께 오지 않습니다. %2</translation>
    </message>
    <message>
        <source>The speaker %1</source>
        <translation>%1의 말하는 사람</translation>
    </message>
    <message>
        <source>The system gives this program no thread to work on; close other programs.</source>
        <translation>시스템이 이 프로그램에 작업을 나눌 자리를 주지 않습니다. 다른 프로그램을 닫으세요.</translation>
    </message>
    <message>
        <source>The system watches only a part of the album&apos;s folders; changes by other programs in the others are noticed %1 seconds later.</source>
        <translation>시스템이 앨범 폴더의 일부만 지켜봅니다. 나머지에서 다른 프로그램이 바꾼 것은 %1초 늦게 알게 됩니다.</translation>
    </message>
    <message>
        <source>The tactile sheet cannot be saved as &quot;%1&quot;: %2</source>
        <translation>촉각 인쇄물을 “%1”(으)로 저장할 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The time %1</source>
        <translation>%1의 시간</translation>
    </message>
    <message>
        <source>The transcript %1</source>
        <translation>%1의 받아쓴 글</translation>
    </message>
    <message>
        <source>The trash could not be emptied: %1</source>
        <translation>휴지통을 비우지 못했습니다. %1</translation>
    </message>
    <message>
        <source>The widths of hysteresis and blending are from 0 to 5 mm.</source>
        <translation>히스테리시스와 블렌딩의 너비는 0에서 5 mm까지입니다.</translation>
    </message>
    <message>
        <source>There is a file %1 already. Choose another name for the recording.</source>
        <translation>파일 %1: 이미 있습니다. 기록에 다른 이름을 고르세요.</translation>
    </message>
    <message>
        <source>There is no braille for the language &quot;%1&quot;; en, de and ko there is.</source>
        <translation>언어 “%1”의 점자는 없습니다. en, de, ko가 있습니다.</translation>
    </message>
    <message>
        <source>There is no device &quot;%1&quot; now. See that it is plugged in; &quot;touchphoto-lab devices&quot; lists what is there.</source>
        <translation>지금 장치 “%1”이(가) 없습니다. 꽂혀 있는지 보세요. “touchphoto-lab devices”가 있는 장치를 알려 줍니다.</translation>
    </message>
    <message>
        <source>There is no face %1 in this picture; it has %2.</source>
        <translation>이 사진에 %1번 얼굴이 없습니다. 얼굴 수는 %2입니다.</translation>
    </message>
    <message>
        <source>There is no file &quot;%1&quot;.</source>
        <translation>파일 “%1”: 없습니다.</translation>
    </message>
    <message>
        <source>There is no file or folder &quot;%1&quot;.</source>
        <translation>“%1”: 그런 파일이나 폴더가 없습니다.</translation>
    </message>
    <message>
        <source>There is no line to draw on these faces.</source>
        <translation>이 얼굴에는 그릴 선이 없습니다.</translation>
    </message>
    <message>
        <source>There is no photograph &quot;%1&quot;.</source>
        <translation>사진 “%1”: 없습니다.</translation>
    </message>
    <message>
        <source>There is no photograph to export.</source>
        <translation>내보낼 사진이 없습니다.</translation>
    </message>
    <message>
        <source>There is no recording &quot;%1&quot; on &quot;%2&quot;.</source>
        <translation>“%2”에 녹음 “%1”이(가) 없습니다.</translation>
    </message>
    <message>
        <source>There is no such file.</source>
        <translation>그런 파일이 없습니다.</translation>
    </message>
    <message>
        <source>There is no unfinished import &quot;%1&quot;.</source>
        <translation>끝나지 않은 가져오기 “%1”이(가) 없습니다.</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture.</source>
        <translation>이 사진을 열 메모리가 모자랍니다.</translation>
    </message>
    <message>
        <source>There is nothing of the name &quot;%1&quot; in the trash.</source>
        <translation>휴지통에 “%1”(이)라는 것이 없습니다.</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>다시 실행할 것이 없습니다.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>되돌릴 것이 없습니다.</translation>
    </message>
    <message>
        <source>This could not be done, because the computer reports: %1</source>
        <translation>컴퓨터의 알림으로 할 수 없었습니다: %1</translation>
    </message>
    <message>
        <source>This is a compressed drawing (svgz); save it as plain SVG.</source>
        <translation>압축된 그림(svgz)입니다. 일반 SVG로 저장하세요.</translation>
    </message>
    <message>
        <source>This is a folder, not a picture.</source>
        <translation>사진이 아니라 폴더입니다.</translation>
    </message>
    <message>
        <source>This is no recording of a force device, or one of a later version of TouchPhoto.</source>
        <translation>힘 장치의 기록이 아니거나 TouchPhoto의 더 새로운 버전에서 만든 기록입니다.</translation>
    </message>
    <message>
        <source>This is not an SVG drawing: it begins with &lt;%1&gt; where &lt;svg&gt; is expected.</source>
        <translation>SVG 그림이 아닙니다. &lt;svg&gt;가 있어야 할 곳이 &lt;%1&gt;(으)로 시작합니다.</translation>
    </message>
    <message>
        <source>This is not an SVG drawing: its text is broken near line %1.</source>
        <translation>SVG 그림이 아닙니다. %1번째 줄 근처에서 글이 깨졌습니다.</translation>
    </message>
    <message>
        <source>This is not an SVG drawing: there is nothing in it.</source>
        <translation>SVG 그림이 아닙니다. 아무것도 들어 있지 않습니다.</translation>
    </message>
    <message>
        <source>This part of the face was not found in the picture.</source>
        <translation>얼굴의 이 부분을 사진에서 찾지 못했습니다.</translation>
    </message>
    <message>
        <source>This picture could not be read. It may be too large for this computer.</source>
        <translation>이 사진을 읽을 수 없습니다. 이 컴퓨터에 너무 큰 사진일 수 있습니다.</translation>
    </message>
    <message>
        <source>This picture could not be worked on. It may be too large for this computer.</source>
        <translation>이 사진을 처리할 수 없습니다. 이 컴퓨터에 너무 큰 사진일 수 있습니다.</translation>
    </message>
    <message>
        <source>What another program wrote cannot be kept: %1</source>
        <translation>다른 프로그램이 쓴 것을 보관할 수 없습니다. %1</translation>
    </message>
    <message>
        <source>What other programs wrote differs in: %1. The other version is in the copy.</source>
        <translation>다른 프로그램이 쓴 것이 서로 다릅니다: %1. 다른 것은 사본에 있습니다.</translation>
    </message>
    <message>
        <source>What the photograph &quot;%1&quot; says of itself cannot be read.</source>
        <translation>사진 “%1”: 사진에 든 정보를 읽을 수 없습니다.</translation>
    </message>
    <message>
        <source>Windows does not let this program use the %1. Unplug it and plug it in again; if that does not help, close other programs that use it.</source>
        <translation>Windows가 이 프로그램이 장치를 쓰지 못하게 합니다: %1. 뽑았다가 다시 꽂으세요. 그래도 안 되면 그 장치를 쓰는 다른 프로그램을 닫으세요.</translation>
    </message>
    <message>
        <source>You are not allowed to read the photograph &quot;%1&quot;.</source>
        <translation>사진 “%1”: 읽을 권한이 없습니다.</translation>
    </message>
    <message>
        <source>You may not use the %1 yet. Copy resources/udev/70-touchphoto.rules to /etc/udev/rules.d, then unplug the device and plug it in again.</source>
        <translation>아직 이 장치를 쓸 권한이 없습니다: %1. resources/udev/70-touchphoto.rules를 /etc/udev/rules.d로 복사한 다음 장치를 뽑았다가 다시 꽂으세요.</translation>
    </message>
    <message>
        <source>a face</source>
        <translation>얼굴</translation>
    </message>
    <message>
        <source>a face lost its name</source>
        <translation>얼굴의 이름 지우기</translation>
    </message>
    <message>
        <source>a face was named %1</source>
        <translation>얼굴에 이름 %1 붙이기</translation>
    </message>
    <message>
        <source>a place of its scene is not two numbers in millimetres.</source>
        <translation>장면의 한 자리가 밀리미터로 된 두 숫자가 아닙니다.</translation>
    </message>
    <message>
        <source>a recording is at most %1 hours long.</source>
        <translation>녹음은 %1시간까지입니다.</translation>
    </message>
    <message>
        <source>a recording is mono or stereo, with 8000 to 192000 samples a second.</source>
        <translation>녹음은 모노나 스테레오이고 초당 샘플이 8000에서 192000까지여야 합니다.</translation>
    </message>
    <message>
        <source>another program holds it.</source>
        <translation>다른 프로그램이 잡고 있습니다.</translation>
    </message>
    <message>
        <source>another program is writing to it.</source>
        <translation>다른 프로그램이 쓰고 있습니다.</translation>
    </message>
    <message>
        <source>another program is writing to it. %1</source>
        <translation>다른 프로그램이 쓰고 있습니다. %1</translation>
    </message>
    <message>
        <source>another program keeps writing to it.</source>
        <translation>다른 프로그램이 계속 쓰고 있습니다.</translation>
    </message>
    <message>
        <source>blurred</source>
        <translation>흐려서</translation>
    </message>
    <message>
        <source>bottom edge</source>
        <translation>아래쪽 가장자리</translation>
    </message>
    <message>
        <source>files that an earlier program left behind are in the way.</source>
        <translation>이전 프로그램이 남긴 파일이 자리를 막고 있습니다.</translation>
    </message>
    <message>
        <source>force pad</source>
        <translation>힘 패드</translation>
    </message>
    <message>
        <source>force pad with a pantograph</source>
        <translation>팬터그래프식 힘 패드</translation>
    </message>
    <message>
        <source>force pad with cables</source>
        <translation>줄로 움직이는 힘 패드</translation>
    </message>
    <message>
        <source>how somebody says %1</source>
        <translation>%1의 이름 소리</translation>
    </message>
    <message>
        <source>is damaged</source>
        <translation>손상되었습니다</translation>
    </message>
    <message>
        <source>it acts more than 50 milliseconds late</source>
        <translation>50밀리초 넘게 늦게 움직입니다</translation>
    </message>
    <message>
        <source>it cannot be read to its end.</source>
        <translation>끝까지 읽을 수 없습니다.</translation>
    </message>
    <message>
        <source>it cannot be read: %1</source>
        <translation>읽을 수 없습니다. %1</translation>
    </message>
    <message>
        <source>it cannot be set aside.</source>
        <translation>치워 둘 수 없습니다.</translation>
    </message>
    <message>
        <source>it cannot be written.</source>
        <translation>쓸 수 없습니다.</translation>
    </message>
    <message>
        <source>it does not begin like a WAV file.</source>
        <translation>WAV 파일처럼 시작하지 않습니다.</translation>
    </message>
    <message>
        <source>it has %1 channels; at most %2 can be read.</source>
        <translation>채널이 %1개입니다. %2개까지 읽을 수 있습니다.</translation>
    </message>
    <message>
        <source>it has more entries than any program writes.</source>
        <translation>어떤 프로그램이 쓰는 것보다 항목이 많습니다.</translation>
    </message>
    <message>
        <source>it has no samples.</source>
        <translation>샘플이 없습니다.</translation>
    </message>
    <message>
        <source>it has no sound.</source>
        <translation>소리가 없습니다.</translation>
    </message>
    <message>
        <source>it holds &quot;%1&quot;, which is not a plain file.</source>
        <translation>일반 파일이 아닌 “%1”이(가) 들어 있습니다.</translation>
    </message>
    <message>
        <source>it holds &quot;%1&quot;, which would lie outside the album.</source>
        <translation>앨범 밖에 놓일 “%1”이(가) 들어 있습니다.</translation>
    </message>
    <message>
        <source>it holds a file in more folders than any album has.</source>
        <translation>어떤 앨범보다도 깊은 폴더에 든 파일이 있습니다.</translation>
    </message>
    <message>
        <source>it holds a file without a name.</source>
        <translation>이름 없는 파일이 들어 있습니다.</translation>
    </message>
    <message>
        <source>it holds more files than any album.</source>
        <translation>어떤 앨범보다도 파일이 많습니다.</translation>
    </message>
    <message>
        <source>it holds no sound.</source>
        <translation>소리가 들어 있지 않습니다.</translation>
    </message>
    <message>
        <source>it is damaged there.</source>
        <translation>그 자리가 손상되었습니다.</translation>
    </message>
    <message>
        <source>it is damaged, and cannot be read to its end.</source>
        <translation>손상되어 끝까지 읽을 수 없습니다.</translation>
    </message>
    <message>
        <source>it is damaged, or no sound file that can be read here.</source>
        <translation>손상되었거나 여기서 읽을 수 없는 소리 파일입니다.</translation>
    </message>
    <message>
        <source>it is damaged, or no video that can be read here.</source>
        <translation>손상되었거나 여기서 읽을 수 없는 동영상입니다.</translation>
    </message>
    <message>
        <source>it is damaged.</source>
        <translation>손상되었습니다.</translation>
    </message>
    <message>
        <source>it is empty.</source>
        <translation>비어 있습니다.</translation>
    </message>
    <message>
        <source>it is larger than %1 MB.</source>
        <translation>%1 MB보다 큽니다.</translation>
    </message>
    <message>
        <source>it is locked with a password.</source>
        <translation>암호로 잠겨 있습니다.</translation>
    </message>
    <message>
        <source>it is longer than %1 hours, or claims to be.</source>
        <translation>%1시간보다 길거나 그렇다고 적혀 있습니다.</translation>
    </message>
    <message>
        <source>it is longer than %1 hours.</source>
        <translation>%1시간보다 깁니다.</translation>
    </message>
    <message>
        <source>it is longer than a minute, so it is a film and not the photograph&apos;s.</source>
        <translation>1분보다 길어서 사진의 소리가 아니라 영화입니다.</translation>
    </message>
    <message>
        <source>it is neither mono nor stereo.</source>
        <translation>모노도 스테레오도 아닙니다.</translation>
    </message>
    <message>
        <source>it is nested more deeply than any program writes.</source>
        <translation>어떤 프로그램이 쓰는 것보다 깊이 겹쳐 있습니다.</translation>
    </message>
    <message>
        <source>it is no setup of the lab of version 1.</source>
        <translation>실험실 설정 버전 1이 아닙니다.</translation>
    </message>
    <message>
        <source>it is no sound file that can be read here.</source>
        <translation>여기서 읽을 수 있는 소리 파일이 아닙니다.</translation>
    </message>
    <message>
        <source>it is not XMP.</source>
        <translation>XMP가 아닙니다.</translation>
    </message>
    <message>
        <source>it is not a FLAC file.</source>
        <translation>FLAC 파일이 아닙니다.</translation>
    </message>
    <message>
        <source>it is not a bundle, or it is damaged.</source>
        <translation>묶음이 아니거나 손상되었습니다.</translation>
    </message>
    <message>
        <source>it is not a file.</source>
        <translation>파일이 아닙니다.</translation>
    </message>
    <message>
        <source>it is not there.</source>
        <translation>파일이 없습니다.</translation>
    </message>
    <message>
        <source>it is not whole XML.</source>
        <translation>온전한 XML이 아닙니다.</translation>
    </message>
    <message>
        <source>it names a law that is unknown.</source>
        <translation>알 수 없는 법칙이 적혀 있습니다.</translation>
    </message>
    <message>
        <source>it reaches farther than two metres</source>
        <translation>2미터 넘게 닿습니다</translation>
    </message>
    <message>
        <source>it reaches less than a square centimetre</source>
        <translation>1제곱센티미터도 닿지 않습니다</translation>
    </message>
    <message>
        <source>it was stopped.</source>
        <translation>멈췄습니다.</translation>
    </message>
    <message>
        <source>it would become larger than any program reads.</source>
        <translation>어떤 프로그램도 읽지 못할 만큼 커집니다.</translation>
    </message>
    <message>
        <source>it would become too large (&quot;%1&quot;).</source>
        <translation>너무 커집니다(“%1”).</translation>
    </message>
    <message>
        <source>its comments are damaged.</source>
        <translation>주석이 손상되었습니다.</translation>
    </message>
    <message>
        <source>its edge is faint</source>
        <translation>경계가 흐려서</translation>
    </message>
    <message>
        <source>its folder is gone.</source>
        <translation>폴더가 없어졌습니다.</translation>
    </message>
    <message>
        <source>its head is damaged.</source>
        <translation>파일의 머리 부분이 손상되었습니다.</translation>
    </message>
    <message>
        <source>its header is damaged.</source>
        <translation>헤더가 손상되었습니다.</translation>
    </message>
    <message>
        <source>its largest force is none or above 20 newtons</source>
        <translation>가장 큰 힘이 0이거나 20뉴턴을 넘습니다</translation>
    </message>
    <message>
        <source>its letters are in an encoding that XMP does not allow.</source>
        <translation>XMP가 허용하지 않는 문자 인코딩입니다.</translation>
    </message>
    <message>
        <source>its name is too long.</source>
        <translation>이름이 너무 깁니다.</translation>
    </message>
    <message>
        <source>its rate is below 50 or above 8000 hertz</source>
        <translation>속도가 50헤르츠보다 낮거나 8000헤르츠보다 높습니다</translation>
    </message>
    <message>
        <source>its sample rate is none of a recording.</source>
        <translation>녹음의 샘플 속도가 아닙니다.</translation>
    </message>
    <message>
        <source>its samples are not of 16 bit.</source>
        <translation>샘플이 16비트가 아닙니다.</translation>
    </message>
    <message>
        <source>its sound cannot be decoded.</source>
        <translation>소리를 해독할 수 없습니다.</translation>
    </message>
    <message>
        <source>its sound has %1 channels; at most %2 can be read.</source>
        <translation>소리의 채널이 %1개입니다. %2개까지 읽을 수 있습니다.</translation>
    </message>
    <message>
        <source>its sound is of a kind that cannot be decoded here (%1).</source>
        <translation>여기서 해독할 수 없는 종류의 소리입니다(%1).</translation>
    </message>
    <message>
        <source>its texts are too long.</source>
        <translation>글이 너무 깁니다.</translation>
    </message>
    <message>
        <source>its watchdog does not wait 20 to 50 milliseconds</source>
        <translation>감시 시간이 20에서 50밀리초까지가 아닙니다</translation>
    </message>
    <message>
        <source>left and bottom edges</source>
        <translation>왼쪽과 아래쪽 가장자리</translation>
    </message>
    <message>
        <source>left and right and bottom edges</source>
        <translation>왼쪽, 오른쪽, 아래쪽 가장자리</translation>
    </message>
    <message>
        <source>left and right and top and bottom edges</source>
        <translation>왼쪽, 오른쪽, 위쪽, 아래쪽 가장자리</translation>
    </message>
    <message>
        <source>left and right and top edges</source>
        <translation>왼쪽, 오른쪽, 위쪽 가장자리</translation>
    </message>
    <message>
        <source>left and right edges</source>
        <translation>왼쪽과 오른쪽 가장자리</translation>
    </message>
    <message>
        <source>left and top and bottom edges</source>
        <translation>왼쪽, 위쪽, 아래쪽 가장자리</translation>
    </message>
    <message>
        <source>left and top edges</source>
        <translation>왼쪽과 위쪽 가장자리</translation>
    </message>
    <message>
        <source>left edge</source>
        <translation>왼쪽 가장자리</translation>
    </message>
    <message>
        <source>left eye</source>
        <translation>왼쪽 눈</translation>
    </message>
    <message>
        <source>macOS does not let this program use the %1. Allow it under System Settings, Privacy &amp; Security, Input Monitoring, and start it again.</source>
        <translation>macOS가 이 프로그램이 장치를 쓰지 못하게 합니다: %1. 시스템 설정의 개인정보 보호 및 보안, 입력 모니터링에서 허용하고 프로그램을 다시 시작하세요.</translation>
    </message>
    <message>
        <source>may be covered</source>
        <translation>가려진 듯하여</translation>
    </message>
    <message>
        <source>mouth</source>
        <translation>입</translation>
    </message>
    <message>
        <source>nothing of it can be read.</source>
        <translation>아무것도 읽을 수 없습니다.</translation>
    </message>
    <message>
        <source>nothing of its sound can be decoded.</source>
        <translation>소리를 전혀 해독할 수 없습니다.</translation>
    </message>
    <message>
        <source>of the recording &quot;%1&quot;</source>
        <translation>녹음 “%1”</translation>
    </message>
    <message>
        <source>outline</source>
        <translation>얼굴 윤곽</translation>
    </message>
    <message>
        <source>reading it needs the library %1 of FFmpeg (Debian: libavformat59), which is not here.</source>
        <translation>읽으려면 FFmpeg의 라이브러리 %1(데비안: libavformat59)이 필요한데 여기에 없습니다.</translation>
    </message>
    <message>
        <source>right and bottom edges</source>
        <translation>오른쪽과 아래쪽 가장자리</translation>
    </message>
    <message>
        <source>right and top and bottom edges</source>
        <translation>오른쪽, 위쪽, 아래쪽 가장자리</translation>
    </message>
    <message>
        <source>right and top edges</source>
        <translation>오른쪽과 위쪽 가장자리</translation>
    </message>
    <message>
        <source>right edge</source>
        <translation>오른쪽 가장자리</translation>
    </message>
    <message>
        <source>right eye</source>
        <translation>오른쪽 눈</translation>
    </message>
    <message>
        <source>simulated device</source>
        <translation>가상 장치</translation>
    </message>
    <message>
        <source>the FLAC encoder reports a fault.</source>
        <translation>FLAC 인코더에 문제가 있습니다.</translation>
    </message>
    <message>
        <source>the ambient</source>
        <translation>주변 소리</translation>
    </message>
    <message>
        <source>the ambient about %1</source>
        <translation>%1에 대한 주변 소리</translation>
    </message>
    <message>
        <source>the disk is full.</source>
        <translation>디스크가 가득 찼습니다.</translation>
    </message>
    <message>
        <source>the disk reports a fault.</source>
        <translation>디스크에 문제가 있습니다.</translation>
    </message>
    <message>
        <source>the face of &quot;%1&quot;</source>
        <translation>“%1”의 얼굴</translation>
    </message>
    <message>
        <source>the memo</source>
        <translation>메모</translation>
    </message>
    <message>
        <source>the memo about %1</source>
        <translation>%1에 대한 메모</translation>
    </message>
    <message>
        <source>the mouse or a finger on the screen</source>
        <translation>마우스나 화면 위의 손가락</translation>
    </message>
    <message>
        <source>the name of %1 was recorded</source>
        <translation>%1의 이름 녹음</translation>
    </message>
    <message>
        <source>the person</source>
        <translation>누구인지 알려 주는 녹음</translation>
    </message>
    <message>
        <source>the person about %1</source>
        <translation>%1이(가) 누구인지 알려 주는 녹음</translation>
    </message>
    <message>
        <source>the place</source>
        <translation>장소 녹음</translation>
    </message>
    <message>
        <source>the place about %1</source>
        <translation>%1에 대한 장소 녹음</translation>
    </message>
    <message>
        <source>the recorded name of %1 became that of %2</source>
        <translation>%1의 이름 녹음을 %2의 것으로 바꾸기</translation>
    </message>
    <message>
        <source>the recordings of %1 were put in order</source>
        <translation>%1의 녹음 순서 바꾸기</translation>
    </message>
    <message>
        <source>the story</source>
        <translation>이야기</translation>
    </message>
    <message>
        <source>the story about %1</source>
        <translation>%1에 대한 이야기</translation>
    </message>
    <message>
        <source>the trash is full of files of that name.</source>
        <translation>휴지통에 같은 이름의 파일이 너무 많습니다.</translation>
    </message>
    <message>
        <source>there are too many files of that name already.</source>
        <translation>같은 이름의 파일이 이미 너무 많습니다.</translation>
    </message>
    <message>
        <source>there are too many photographs of that name in the album.</source>
        <translation>앨범에 같은 이름의 사진이 너무 많습니다.</translation>
    </message>
    <message>
        <source>there is a file of that name already.</source>
        <translation>같은 이름의 파일이 이미 있습니다.</translation>
    </message>
    <message>
        <source>there is no folder &quot;%1&quot;.</source>
        <translation>폴더 “%1”이(가) 없습니다.</translation>
    </message>
    <message>
        <source>there is no such file.</source>
        <translation>그런 파일이 없습니다.</translation>
    </message>
    <message>
        <source>there is no such piece in it.</source>
        <translation>그런 부분이 없습니다.</translation>
    </message>
    <message>
        <source>there is not enough memory for it.</source>
        <translation>메모리가 모자랍니다.</translation>
    </message>
    <message>
        <source>there is not enough memory.</source>
        <translation>메모리가 모자랍니다.</translation>
    </message>
    <message>
        <source>they belong to a picture of another shape, %1 × %2 pixels.</source>
        <translation>모양이 다른 사진(%1 × %2픽셀)의 것입니다.</translation>
    </message>
    <message>
        <source>they lie on different disks.</source>
        <translation>서로 다른 디스크에 있습니다.</translation>
    </message>
    <message>
        <source>too small</source>
        <translation>너무 작아서</translation>
    </message>
    <message>
        <source>top and bottom edges</source>
        <translation>위쪽과 아래쪽 가장자리</translation>
    </message>
    <message>
        <source>top edge</source>
        <translation>위쪽 가장자리</translation>
    </message>
    <message>
        <source>turned to the side</source>
        <translation>옆으로 돌아가서</translation>
    </message>
    <message>
        <source>was written by a newer version of this program</source>
        <translation>이 프로그램의 더 새로운 버전에서 만들어졌습니다</translation>
    </message>
    <message>
        <source>what was written is not what was to be written; the disk or the memory may be faulty.</source>
        <translation>쓰인 것이 쓰려던 것과 다릅니다. 디스크나 메모리에 문제가 있을 수 있습니다.</translation>
    </message>
    <message>
        <source>you are not allowed to read it.</source>
        <translation>읽을 권한이 없습니다.</translation>
    </message>
    <message>
        <source>you are not allowed to write there.</source>
        <translation>거기에 쓸 권한이 없습니다.</translation>
    </message>
    <message>
        <source>A calibration sample is no place; touch the marks again.</source>
        <translation>보정에 쓸 수 없는 측정값이 있습니다. 표시를 다시 누르세요.</translation>
    </message>
    <message>
        <source>The calibration could not be kept: %1</source>
        <translation>보정을 저장하지 못했습니다: %1</translation>
    </message>
    <message>
        <source>Too many touches do not fit together. Touch the marks again with the finger in the device, and with no other.</source>
        <translation>서로 맞지 않는 누름이 너무 많습니다. 손가락을 장치에 넣고, 그 손가락만으로 표시를 다시 누르세요.</translation>
    </message>
    <message>
        <source>the device has no name to keep it by.</source>
        <translation>저장할 때 쓸 장치 이름이 없습니다.</translation>
    </message>
    <message>
        <source>This device needs no homing.</source>
        <translation>이 장치는 기준점을 맞출 필요가 없습니다.</translation>
    </message>
    <message>
        <source>The force stick cannot be used: %1.</source>
        <translation>힘 스틱을 사용할 수 없습니다: %1.</translation>
    </message>
    <message>
        <source>The force stick does not take up a force. Unplug it and plug it in again.</source>
        <translation>힘 스틱이 힘을 받아들이지 않습니다. 뽑았다가 다시 꽂으십시오.</translation>
    </message>
    <message>
        <source>The force stick does not take what this computer sends. It goes on by itself when it does.</source>
        <translation>힘 스틱이 이 컴퓨터가 보내는 것을 받지 않습니다. 다시 받으면 저절로 계속됩니다.</translation>
    </message>
    <message>
        <source>The force stick has no room for a force. Close other programs that use it, unplug it and plug it in again.</source>
        <translation>힘 스틱에 힘을 넣을 자리가 없습니다. 이 장치를 쓰는 다른 프로그램을 닫고, 뽑았다가 다시 꽂으십시오.</translation>
    </message>
    <message>
        <source>The force stick has switched its motors off. See that its power supply is plugged in and that no other program uses it.</source>
        <translation>힘 스틱이 모터를 껐습니다. 전원 어댑터가 꽂혀 있는지, 다른 프로그램이 사용하고 있지 않은지 확인하십시오.</translation>
    </message>
    <message>
        <source>The force stick&apos;s safety switch keeps its motors off. Hold the grip as its maker says, or release the switch.</source>
        <translation>힘 스틱의 안전 스위치 때문에 모터가 꺼져 있습니다. 제조사가 안내한 대로 손잡이를 잡거나 스위치를 푸십시오.</translation>
    </message>
    <message>
        <source>force stick</source>
        <translation>힘 스틱</translation>
    </message>
    <message>
        <source>it does not have two axes</source>
        <translation>축이 두 개가 아닙니다</translation>
    </message>
    <message>
        <source>it does not keep its effects itself</source>
        <translation>효과를 스스로 관리하지 않습니다</translation>
    </message>
    <message>
        <source>it has no constant force</source>
        <translation>일정한 힘을 내지 못합니다</translation>
    </message>
    <message>
        <source>its effects have no numbers</source>
        <translation>효과에 번호가 없습니다</translation>
    </message>
    <message>
        <source>its force has no direction</source>
        <translation>힘에 방향이 없습니다</translation>
    </message>
    <message>
        <source>its force has no sign</source>
        <translation>힘에 부호가 없습니다</translation>
    </message>
    <message>
        <source>its reports are too long</source>
        <translation>보고서가 너무 깁니다</translation>
    </message>
    <message>
        <source>what it says of itself makes no sense</source>
        <translation>스스로에 대해 알리는 내용이 이치에 맞지 않습니다</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not say in what language a name is read: %2 Move it away, then choose the language again.</source>
        <translation>“%1”에서 이름을 읽는 언어를 알 수 없습니다: %2 파일을 다른 곳으로 옮긴 다음 언어를 다시 고르세요.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no tag of a language, such as de or pt-BR.</source>
        <translation>“%1”은(는) de 나 pt-BR 같은 언어 태그가 아닙니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; says how the name of %2 is read, and does not have its place.</source>
        <translation>“%1”은(는) %2의 이름을 읽는 언어를 담고 있지만 제자리에 있지 않습니다.</translation>
    </message>
    <message>
        <source>A person needs a name before its language can be chosen.</source>
        <translation>이름의 언어를 고르려면 먼저 사람의 이름이 있어야 합니다.</translation>
    </message>
    <message>
        <source>The language of the name cannot be kept: %1</source>
        <translation>이름의 언어를 저장할 수 없습니다: %1</translation>
    </message>
    <message>
        <source>its first line is no tag of a language, such as de or pt-BR.</source>
        <translation>첫 줄이 de 나 pt-BR 같은 언어 태그가 아닙니다.</translation>
    </message>
    <message>
        <source>its second line does not say whose name it is.</source>
        <translation>둘째 줄에 누구의 이름인지 적혀 있지 않습니다.</translation>
    </message>
    <message>
        <source>the language of the name of %1</source>
        <translation>%1의 이름을 읽는 언어</translation>
    </message>
    <message>
        <source>the language of the name of %1 was chosen</source>
        <translation>%1의 이름을 읽는 언어 선택</translation>
    </message>
    <message>
        <source>the language of the name of %1 became that of %2</source>
        <translation>%1의 이름을 읽는 언어를 %2의 것으로 바꾸기</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not the firmware of a Falcon: it is too small. Copy the right file there.</source>
        <translation>“%1”은(는) 팰컨의 펌웨어가 아닙니다. 파일이 너무 작습니다. 올바른 파일을 그곳에 복사하세요.</translation>
    </message>
    <message>
        <source>Novint Falcon</source>
        <translation>노빈트 팰컨</translation>
    </message>
    <message>
        <source>The Falcon did not take its firmware, though it was tried again and again. Plug its USB cable into this computer itself, not into a hub, and try once more.</source>
        <translation>여러 번 시도했지만 팰컨이 펌웨어를 받지 않았습니다. USB 케이블을 허브가 아니라 이 컴퓨터에 직접 꽂고 다시 시도하세요.</translation>
    </message>
    <message>
        <source>The Falcon does not answer. See that it is plugged in and has power, and try again.</source>
        <translation>팰컨이 응답하지 않습니다. 연결되어 있고 전원이 들어오는지 확인한 뒤 다시 시도하세요.</translation>
    </message>
    <message>
        <source>The Falcon does not answer. See that its power supply is plugged in, unplug its USB cable, plug it in again and try once more.</source>
        <translation>팰컨이 응답하지 않습니다. 전원 어댑터가 꽂혀 있는지 확인하고 USB 케이블을 뽑았다가 다시 꽂은 뒤 다시 시도하세요.</translation>
    </message>
    <message>
        <source>The Falcon does not know where its grip is. Home it: pull the grip out as far as it goes, then push it in.</source>
        <translation>팰컨이 손잡이의 위치를 모릅니다. 기준점을 잡으세요. 손잡이를 끝까지 당겼다가 밀어 넣으세요.</translation>
    </message>
    <message>
        <source>The Falcon is not homed yet. Home it again, and while its light is blue pull the grip out as far as it goes, then push it in.</source>
        <translation>팰컨의 기준점이 아직 잡히지 않았습니다. 다시 기준점을 잡고, 불빛이 파란색인 동안 손잡이를 끝까지 당겼다가 밀어 넣으세요.</translation>
    </message>
    <message>
        <source>The Falcon needs its firmware, which its maker does not let this program bring along. Copy the firmware file of its maker&apos;s software to %1.</source>
        <translation>팰컨에는 펌웨어가 필요하지만 제조사가 이 프로그램에 넣는 것을 허락하지 않습니다. 제조사 소프트웨어의 펌웨어 파일을 %1(으)로 복사하세요.</translation>
    </message>
    <message>
        <source>The Falcon took its firmware and does not answer. Perhaps %1 is not the firmware of a Falcon.</source>
        <translation>팰컨이 펌웨어를 받았지만 응답하지 않습니다. %1이(가) 팰컨의 펌웨어가 아닐 수 있습니다.</translation>
    </message>
    <message>
        <source>The Falcon was unplugged while it was started. Plug it in again.</source>
        <translation>팰컨을 시작하는 동안 연결이 끊어졌습니다. 다시 연결하세요.</translation>
    </message>
    <message>
        <source>Another program or the system keeps the %1 from this one. Close other programs that use it, unplug it and plug it in again.</source>
        <translation>다른 프로그램이나 시스템이 %1 장치를 놓아주지 않습니다. 그 장치를 쓰는 다른 프로그램을 닫고, 장치를 뽑았다가 다시 꽂으세요.</translation>
    </message>
    <message>
        <source>Arduino board: a Haply 2diy of the first generation?</source>
        <translation>아두이노 보드: 1세대 Haply 2diy인가요?</translation>
    </message>
    <message>
        <source>Arduino board: a Haply 2diy of the third generation?</source>
        <translation>아두이노 보드: 3세대 Haply 2diy인가요?</translation>
    </message>
    <message>
        <source>The Haply 2diy could not be homed. See that it is plugged in and switched on, and try again.</source>
        <translation>Haply 2diy의 기준점을 잡지 못했습니다. 꽂혀 있고 켜져 있는지 확인하고 다시 시도하세요.</translation>
    </message>
    <message>
        <source>The Haply 2diy does not know where its arms are. Put both arms on their marks and home it.</source>
        <translation>Haply 2diy가 팔의 위치를 모릅니다. 두 팔을 표시에 맞추고 기준점을 잡으세요.</translation>
    </message>
    <message>
        <source>The Haply 2diy lost count of where its arms are. Put both arms on their marks and home it.</source>
        <translation>Haply 2diy가 팔의 위치를 놓쳤습니다. 두 팔을 표시에 맞추고 기준점을 잡으세요.</translation>
    </message>
    <message>
        <source>The device at the serial port does not answer like a Haply 2diy. Switch it on, unplug it and plug it in again; if it is no Haply 2diy, choose another device.</source>
        <translation>직렬 포트의 장치가 Haply 2diy처럼 응답하지 않습니다. 장치를 켜고, 뽑았다가 다시 꽂으세요. Haply 2diy가 아니면 다른 장치를 고르세요.</translation>
    </message>
    <message>
        <source>The device stays off, because nothing would watch over its motors on this system.</source>
        <translation>이 시스템에는 모터를 지켜볼 것이 없어서 장치를 켜지 않습니다.</translation>
    </message>
    <message>
        <source>The device stays off, because the program that watches over its motors, touchphoto-force-guard, does not start. Install TouchPhoto again.</source>
        <translation>모터를 지켜보는 프로그램 touchphoto-force-guard가 시작되지 않아서 장치를 켜지 않습니다. TouchPhoto를 다시 설치하세요.</translation>
    </message>
    <message>
        <source>The device stays off, because the program that watches over its motors, touchphoto-force-guard, is not beside this one. Install TouchPhoto again.</source>
        <translation>모터를 지켜보는 프로그램 touchphoto-force-guard가 이 프로그램 옆에 없어서 장치를 켜지 않습니다. TouchPhoto를 다시 설치하세요.</translation>
    </message>
    <message>
        <source>The program that watches over the motors of the Haply 2diy has ended, so they stay off. Start the device again.</source>
        <translation>Haply 2diy의 모터를 지켜보는 프로그램이 끝나서 모터를 켜지 않습니다. 장치를 다시 시작하세요.</translation>
    </message>
    <message>
        <source>This computer has no room for the program that watches over the motors. Close other programs and try again.</source>
        <translation>이 컴퓨터에는 모터를 지켜보는 프로그램을 실행할 여유가 없습니다. 다른 프로그램을 닫고 다시 시도하세요.</translation>
    </message>
    <message>
        <source>You may not use the %1 yet. Copy resources/udev/70-touchphoto.rules to /etc/udev/rules.d, then unplug the device and plug it in again; or have yourself added to the group dialout and log in again.</source>
        <translation>아직 %1 장치를 쓸 권한이 없습니다. resources/udev/70-touchphoto.rules를 /etc/udev/rules.d에 복사한 다음 장치를 뽑았다가 다시 꽂으세요. 또는 dialout 그룹에 추가해 달라고 하고 다시 로그인하세요.</translation>
    </message>
    <message>
        <source>it holds &quot;%1&quot;, which is packed in an unusual way. Pack it again as an ordinary ZIP file.</source>
        <translation>흔하지 않은 방식으로 압축된 “%1”이(가) 들어 있습니다. 일반 ZIP 파일로 다시 압축하세요.</translation>
    </message>
    <message>
        <source>A stick cannot be as strong or as weak as that. See that the scale shows grams and pulls straight towards you, and weigh again.</source>
        <translation>스틱이 그렇게 세거나 약할 수는 없습니다. 저울이 그램을 보여 주고 곧게 자기 쪽으로 당기는지 확인하고 다시 다십시오.</translation>
    </message>
    <message>
        <source>The stick does not pull now. Hold the grip where it is, and weigh again.</source>
        <translation>스틱이 지금 당기지 않습니다. 손잡이를 그 자리에 잡고 다시 다십시오.</translation>
    </message>
    <message>
        <source>What the scale shows must be a number of grams from 0 to 100000.</source>
        <translation>저울이 보여 주는 것은 0에서 100000까지의 그램 수여야 합니다.</translation>
    </message>
    <message>
        <source>What was measured of the stick could not be kept: %1</source>
        <translation>스틱에서 잰 것을 저장할 수 없습니다: %1</translation>
    </message>
    <message>
        <source>the stick has no name to keep it by.</source>
        <translation>저장할 때 쓸 스틱의 이름이 없습니다.</translation>
    </message>
    <message>
        <source>there is no folder for settings.</source>
        <translation>설정 폴더가 없습니다.</translation>
    </message>
    <message>
        <source>The program that watches over the motors of the force stick has ended, so they stay off. Start the device again.</source>
        <translation>힘 스틱의 모터를 지켜보는 프로그램이 끝나서 모터를 켜지 않습니다. 장치를 다시 시작하세요.</translation>
    </message>
    <message>
        <source>The program that watches over the motors of the Falcon has ended, so they stay off. Start the device again.</source>
        <translation>Falcon의 모터를 지켜보는 프로그램이 끝나서 모터를 켜지 않습니다. 장치를 다시 시작하세요.</translation>
    </message>
    <message>
        <source>Pictures in the formats HEIC and AVIF need the library libheif (Debian: libheif1), which is not here: install it or save the picture as JPEG.</source>
        <translation>HEIC와 AVIF 형식의 사진에는 libheif 라이브러리(Debian: libheif1)가 필요하지만 여기에는 없습니다. 설치하거나 사진을 JPEG로 저장하세요.</translation>
    </message>
    <message>
        <source>The %1 file holds a kind of picture that cannot be decoded here: save it as JPEG.</source>
        <translation>%1 파일에 여기서 해독할 수 없는 종류의 사진이 들어 있습니다. JPEG로 저장하세요.</translation>
    </message>
    <message>
        <source>The %1 file is cut short: a part of the picture is missing.</source>
        <translation>%1 파일이 중간에서 끊겨 사진의 일부가 없습니다.</translation>
    </message>
    <message>
        <source>The %1 file says that it holds more than any photograph does; it was not read.</source>
        <translation>%1 파일이 어떤 사진보다도 많은 것을 담고 있다고 하여 읽지 않았습니다.</translation>
    </message>
    <message>
        <source>The raw file holds no preview that can be read: save the picture as JPEG.</source>
        <translation>RAW 파일에 읽을 수 있는 미리보기가 없습니다. 사진을 JPEG로 저장하세요.</translation>
    </message>
    <message>
        <source>A beard hides the jaw, so the outline may be wrong.</source>
        <translation>수염이 턱을 가려 얼굴 윤곽선이 틀릴 수 있습니다.</translation>
    </message>
    <message>
        <source>Hair hides the jaw, so the outline may be wrong.</source>
        <translation>머리카락이 턱을 가려 얼굴 윤곽선이 틀릴 수 있습니다.</translation>
    </message>
    <message>
        <source>a beard hides it</source>
        <translation>수염에 가려져</translation>
    </message>
    <message>
        <source>hair hides it</source>
        <translation>머리카락에 가려져</translation>
    </message>
    <message>
        <source>The picture %1 could not be written: %2</source>
        <translation>사진 %1: 쓰지 못했습니다. %2</translation>
    </message>
    <message>
        <source>it holds &quot;%1&quot; twice.</source>
        <translation>“%1”이(가) 두 번 들어 있습니다.</translation>
    </message>
    <message>
        <source>it holds no photograph.</source>
        <translation>사진이 들어 있지 않습니다.</translation>
    </message>
    <message>
        <source>the picture is empty, or its ending is neither png nor jpg.</source>
        <translation>사진이 비어 있거나 파일 이름이 png나 jpg로 끝나지 않습니다.</translation>
    </message>
    <message>
        <source>That is more at once than an import takes: import the folder that the files are in.</source>
        <translation>한 번에 가져올 수 있는 것보다 많습니다. 파일이 들어 있는 폴더를 가져오십시오.</translation>
    </message>
    <message>
        <source>it lists more people, words or recordings than any photograph has.</source>
        <translation>어떤 사진에 있는 것보다 많은 사람, 낱말 또는 녹음을 나열합니다.</translation>
    </message>
    <message>
        <source>Such files are decoded in a process that can do nothing else, and this system does not allow that (%1): save the picture as JPEG.</source>
        <translation>이런 파일은 다른 일은 할 수 없는 프로세스에서 해독하는데, 이 시스템에서는 그렇게 할 수 없습니다(%1). 사진을 JPEG로 저장하세요.</translation>
    </message>
    <message>
        <source>The picture cannot be decoded: decoding it broke off. The file may be damaged.</source>
        <translation>사진을 해독할 수 없습니다. 해독이 중단되었습니다. 파일이 손상되었을 수 있습니다.</translation>
    </message>
    <message>
        <source>The picture takes too long to decode; it was not read.</source>
        <translation>사진을 해독하는 데 시간이 너무 오래 걸려 읽지 않았습니다.</translation>
    </message>
    <message>
        <source>The program %1, which decodes such files, cannot be started: install TouchPhoto anew.</source>
        <translation>이런 파일을 해독하는 프로그램 %1을(를) 시작할 수 없습니다. TouchPhoto를 다시 설치하세요.</translation>
    </message>
    <message>
        <source>its sound cannot be decoded: decoding it broke off. It may be damaged.</source>
        <translation>소리를 해독할 수 없습니다. 해독이 중단되었습니다. 손상되었을 수 있습니다.</translation>
    </message>
    <message>
        <source>its sound takes too long to decode.</source>
        <translation>소리를 해독하는 데 시간이 너무 오래 걸립니다.</translation>
    </message>
    <message>
        <source>it is not a photograph of a kind that can be read here.</source>
        <translation>여기에서 읽을 수 있는 종류의 사진이 아닙니다.</translation>
    </message>
</context>
<context>
    <name>SettingsPage</name>
    <message>
        <source>Tab goes from setting to setting, Space or Return changes one, arrow keys move a slider. Control Z undoes the last change. Each change is kept at once.</source>
        <translation>탭 키로 설정 사이를 이동하고, 스페이스바나 엔터 키로 설정을 바꾸며, 화살표 키로 슬라이더를 움직입니다. Ctrl Z는 마지막 변경을 되돌립니다. 변경은 바로 저장됩니다.</translation>
    </message>
    <message>
        <source>Speech and sound</source>
        <translation>말과 소리</translation>
    </message>
    <message>
        <source>Who speaks</source>
        <translation>음성 안내</translation>
    </message>
    <message>
        <source>Speed of speech</source>
        <translation>말하는 속도</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>언어</translation>
    </message>
    <message>
        <source>Speed of recordings</source>
        <translation>녹음 재생 속도</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1배</translation>
    </message>
    <message>
        <source>Sounds for what happens</source>
        <translation>동작을 알리는 소리</translation>
    </message>
    <message>
        <source>What it looks like</source>
        <translation>화면 모양</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>색</translation>
    </message>
    <message>
        <source>Size of text</source>
        <translation>글자 크기</translation>
    </message>
    <message>
        <source>%1 percent</source>
        <translation>%1퍼센트</translation>
    </message>
    <message>
        <source>Pictures may move</source>
        <translation>그림의 움직임 허용</translation>
    </message>
    <message>
        <source>Who uses the tablet most</source>
        <translation>태블릿을 주로 쓰는 사람</translation>
    </message>
    <message>
        <source>What is felt</source>
        <translation>만져지는 것</translation>
    </message>
    <message>
        <source>Strongest force</source>
        <translation>최대 힘</translation>
    </message>
    <message>
        <source>%1 newtons</source>
        <translation>%1뉴턴</translation>
    </message>
    <message>
        <source>Try the force on a face</source>
        <translation>얼굴에서 힘을 시험해 보기</translation>
    </message>
    <message>
        <source>What guides the finger where no force does</source>
        <translation>힘이 없는 곳에서 손가락을 이끄는 방법</translation>
    </message>
    <message>
        <source>Brows</source>
        <translation>눈썹</translation>
    </message>
    <message>
        <source>Nose</source>
        <translation>코</translation>
    </message>
    <message>
        <source>Irises</source>
        <translation>홍채</translation>
    </message>
    <message>
        <source>Folders of the album</source>
        <translation>앨범의 폴더</translation>
    </message>
    <message>
        <source>No folder yet.</source>
        <translation>아직 폴더가 없습니다.</translation>
    </message>
    <message>
        <source>Remove %1 from the album</source>
        <translation>앨범에서 빼기: %1</translation>
    </message>
    <message>
        <source>The photographs stay where they are</source>
        <translation>사진은 그 자리에 그대로 남습니다</translation>
    </message>
    <message>
        <source>Add a folder</source>
        <translation>폴더 추가</translation>
    </message>
    <message>
        <source>What is stored about me</source>
        <translation>저장된 내 정보</translation>
    </message>
    <message>
        <source>Throw the index away and make it anew</source>
        <translation>색인을 버리고 새로 만들기</translation>
    </message>
    <message>
        <source>All settings</source>
        <translation>모든 설정</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>되돌릴 것이 없습니다</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>되돌리기: %1</translation>
    </message>
    <message>
        <source>Key: Control Z</source>
        <translation>Ctrl Z 키</translation>
    </message>
    <message>
        <source>Ask me the five questions again</source>
        <translation>처음의 다섯 가지 질문을 다시 하기</translation>
    </message>
    <message>
        <source>Everything as it was at first</source>
        <translation>모두 처음 상태로</translation>
    </message>
    <message>
        <source>The album&apos;s folders stay; it can be undone</source>
        <translation>앨범의 폴더는 그대로 남으며, 되돌릴 수 있습니다</translation>
    </message>
    <message>
        <source>Force device</source>
        <translation>힘 장치</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>보정</translation>
    </message>
    <message>
        <source>Calibrate the device on this screen</source>
        <translation>이 화면에서 장치 보정하기</translation>
    </message>
    <message>
        <source>The four corners of the screen are touched with the device</source>
        <translation>장치로 화면의 네 모서리를 건드립니다</translation>
    </message>
    <message>
        <source>Try the strongest force</source>
        <translation>가장 강한 힘 느껴 보기</translation>
    </message>
    <message>
        <source>The device pulls to the right and to the left for less than three seconds. Escape ends it</source>
        <translation>장치가 3초가 안 되는 동안 오른쪽과 왼쪽으로 당깁니다. Escape 키로 끝냅니다</translation>
    </message>
    <message>
        <source>Home the device</source>
        <translation>장치 기준점 맞추기</translation>
    </message>
    <message>
        <source>Put its handle on the mark first, and leave it there</source>
        <translation>먼저 손잡이를 표시 위에 놓고 그대로 두세요</translation>
    </message>
    <message>
        <source>Measure the stick</source>
        <translation>힘 스틱 재기</translation>
    </message>
    <message>
        <source>How strong it is and which way it pulls. You need a kitchen scale or a luggage scale</source>
        <translation>얼마나 세고 어느 쪽으로 당기는지. 주방 저울이나 여행 가방 저울이 필요합니다</translation>
    </message>
</context>
<context>
    <name>ShellView</name>
    <message>
        <source>Home</source>
        <translation>홈</translation>
    </message>
    <message>
        <source>Key: Escape</source>
        <translation>Escape 키</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>도움말</translation>
    </message>
    <message>
        <source>Says what can be done here. Key: F1</source>
        <translation>여기서 할 수 있는 일을 말해 줍니다. F1 키</translation>
    </message>
    <message>
        <source>Said last</source>
        <translation>마지막에 한 말</translation>
    </message>
</context>
<context>
    <name>SidePanel</name>
    <message>
        <source>Explore</source>
        <translation>살펴보기</translation>
    </message>
    <message>
        <source>Under the finger: nothing</source>
        <translation>손가락 아래: 없음</translation>
    </message>
    <message>
        <source>Under the finger: %1</source>
        <translation>손가락 아래: %1</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>안내 끝내기</translation>
    </message>
    <message>
        <source>Guided tour</source>
        <translation>부위 안내</translation>
    </message>
    <message>
        <source>Leads the finger once round the feature. Key: Space</source>
        <translation>손가락을 이끌어 부위를 한 바퀴 돕니다. 스페이스바</translation>
    </message>
    <message>
        <source>Tour of the face</source>
        <translation>얼굴 안내</translation>
    </message>
    <message>
        <source>Leads the finger round every feature, each named before. Key: T</source>
        <translation>부위 이름을 먼저 말하고, 손가락을 이끌어 모든 부위를 차례로 돕니다. T 키</translation>
    </message>
    <message>
        <source>Where am I?</source>
        <translation>여기는 어디인가요?</translation>
    </message>
    <message>
        <source>Tells face, feature, direction and distance. Key: W</source>
        <translation>얼굴, 부위, 방향, 거리를 말해 줍니다. W 키</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>멈춤</translation>
    </message>
    <message>
        <source>Force on</source>
        <translation>힘 켜기</translation>
    </message>
    <message>
        <source>Ends tour, speech and force. Key: Escape</source>
        <translation>안내와 말과 힘을 끝냅니다. Escape 키</translation>
    </message>
    <message>
        <source>Key: Enter</source>
        <translation>엔터 키</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>확대</translation>
    </message>
    <message>
        <source>To the face, its eyes, its mouth, and back. Key: Z</source>
        <translation>얼굴, 눈, 입을 차례로 확대하고 다시 돌아옵니다. Z 키</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>축소</translation>
    </message>
    <message>
        <source>Key: Shift and Z</source>
        <translation>Shift와 Z 키</translation>
    </message>
    <message>
        <source>Next feature</source>
        <translation>다음 부위</translation>
    </message>
    <message>
        <source>Sets the finger down on it. Key: Tab</source>
        <translation>그 위에 손가락을 놓습니다. 탭 키</translation>
    </message>
    <message>
        <source>Next face</source>
        <translation>다음 얼굴</translation>
    </message>
    <message>
        <source>Fits one face after the other into the surface. Key: F</source>
        <translation>얼굴을 하나씩 차례로 터치 영역에 맞춥니다. F 키</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>길잡이</translation>
    </message>
    <message>
        <source>Strongest force</source>
        <translation>최대 힘</translation>
    </message>
    <message>
        <source>%1 newtons</source>
        <translation>%1뉴턴</translation>
    </message>
    <message>
        <source>Voice</source>
        <translation>음성</translation>
    </message>
    <message>
        <source>Open photograph…</source>
        <translation>사진 열기…</translation>
    </message>
    <message>
        <source>Key: O</source>
        <translation>O 키</translation>
    </message>
    <message>
        <source>Device: %1</source>
        <translation>장치: %1</translation>
    </message>
    <message>
        <source>Next photograph</source>
        <translation>다음 사진</translation>
    </message>
    <message>
        <source>The next one of the album with a face. Key: N</source>
        <translation>앨범에서 얼굴이 있는 다음 사진. N 키</translation>
    </message>
    <message>
        <source>Previous photograph</source>
        <translation>이전 사진</translation>
    </message>
    <message>
        <source>Key: Shift and N</source>
        <translation>Shift와 N 키</translation>
    </message>
</context>
<context>
    <name>SoundsDialog</name>
    <message>
        <source>Add sound files</source>
        <translation>소리 파일 추가</translation>
    </message>
    <message>
        <source>Sounds (%1)</source>
        <translation>소리 (%1)</translation>
    </message>
    <message>
        <source>All files (%1)</source>
        <translation>모든 파일 (%1)</translation>
    </message>
</context>
<context>
    <name>StartPage</name>
    <message>
        <source>Press the number of an answer, or the answer itself. 0 or Backspace: previous question. R: repeat the question.</source>
        <translation>답의 번호를 누르거나 답을 직접 누르세요. 0이나 백스페이스: 이전 질문. R: 질문 다시 듣기.</translation>
    </message>
    <message>
        <source>Press the number of what you want to do, or go through the buttons with Tab. R: repeat this page.</source>
        <translation>하고 싶은 일의 번호를 누르거나, 탭 키로 버튼 사이를 이동하세요. R: 이 페이지 다시 듣기.</translation>
    </message>
    <message>
        <source>Question %1 of %2</source>
        <translation>질문 %2개 중 %1번째</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>다시 듣기</translation>
    </message>
    <message>
        <source>Key: R</source>
        <translation>R 키</translation>
    </message>
    <message>
        <source>Previous question</source>
        <translation>이전 질문</translation>
    </message>
    <message>
        <source>Key: 0</source>
        <translation>0 키</translation>
    </message>
</context>
<context>
    <name>StickMeasuring</name>
    <message>
        <source>The stick will move by itself, a little to the right and back, then a little away from you and back. Let it stand free, and keep your hands off it.</source>
        <translation>스틱이 저절로 조금 오른쪽으로 갔다가 돌아오고, 이어서 조금 앞쪽으로 갔다가 돌아옵니다. 자유롭게 세워 두고 손을 떼십시오.</translation>
    </message>
    <message>
        <source>It is known now which way it pulls. Hold its grip with a kitchen scale or a luggage scale, straight towards you: the stick pulls away from you. When the grip stands still, enter how many grams the scale shows.</source>
        <translation>이제 어느 쪽으로 당기는지 압니다. 주방 저울이나 여행 가방 저울로 손잡이를 곧게 자기 쪽으로 잡으십시오. 스틱은 앞쪽으로 당깁니다. 손잡이가 멈추면 저울이 보여 주는 그램 수를 입력하십시오.</translation>
    </message>
    <message>
        <source>The stick is measured.</source>
        <translation>스틱을 쟀습니다.</translation>
    </message>
    <message>
        <source>The stick did not stand still. Let go of it, see that nothing touches it, and measure again.</source>
        <translation>스틱이 가만히 있지 않았습니다. 손을 떼고 아무것도 닿지 않는지 확인하고 다시 재십시오.</translation>
    </message>
    <message>
        <source>The stick did not move. See that its power supply is plugged in, keep your hands off it, and measure again.</source>
        <translation>스틱이 움직이지 않았습니다. 전원 어댑터가 꽂혀 있는지 확인하고 손을 뗀 채 다시 재십시오.</translation>
    </message>
    <message>
        <source>The stick moved to the side of where it was to move. It cannot be measured so: see that nothing touches it and that it stands straight, and measure again.</source>
        <translation>스틱이 가야 할 쪽에서 벗어나 움직였습니다. 그렇게는 잴 수 없습니다. 아무것도 닿지 않고 곧게 서 있는지 확인하고 다시 재십시오.</translation>
    </message>
    <message>
        <source>The stick did not come back as it went. See that nothing touches it, and measure again.</source>
        <translation>스틱이 간 대로 돌아오지 않았습니다. 아무것도 닿지 않는지 확인하고 다시 재십시오.</translation>
    </message>
    <message>
        <source>The stick was not weighed for three minutes, and its force is off. Measure it again when a scale is at hand.</source>
        <translation>삼 분 동안 스틱을 달지 않아 힘을 껐습니다. 저울이 준비되면 다시 재십시오.</translation>
    </message>
</context>
<context>
    <name>SurfaceView</name>
    <message>
        <source>Touch surface</source>
        <translation>터치 영역</translation>
    </message>
    <message>
        <source>Move a finger to hear what is under it. Arrow keys move the hand, Tab goes from feature to feature, Space starts the guided tour, Z zooms in.</source>
        <translation>손가락을 움직이면 그 아래에 무엇이 있는지 들립니다. 화살표 키는 손을 움직이고, 탭 키는 다음 부위로 가고, 스페이스바는 안내를 시작하고, Z는 확대합니다.</translation>
    </message>
    <message>
        <source>No photograph yet. Press O, or drop one here.</source>
        <translation>아직 사진이 없습니다. O를 누르거나 여기에 사진을 끌어다 놓으세요.</translation>
    </message>
</context>
<context>
    <name>TactileNotes</name>
    <message numerus="yes">
        <source>%n character(s) of the name %1 have no braille and are left out.</source>
        <translation>
            <numerusform>이름 %1: 점자로 쓸 수 없는 글자 %n개를 뺐습니다.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The name %1 is cut after %n line(s) of braille.</source>
        <translation>
            <numerusform>이름 %1: 점자 %n줄까지만 넣고 나머지는 잘랐습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>The %1 is drawn as one line, because its two sides would be too close to be told apart.</source>
        <translation>%1: 양쪽 선이 너무 가까워 구별할 수 없으므로 한 줄로 그렸습니다.</translation>
    </message>
    <message>
        <source>The %1 is drawn in part, because the rest would be less than 3 mm from another line.</source>
        <translation>%1: 나머지가 다른 선과 3 mm보다 가까워지므로 일부만 그렸습니다.</translation>
    </message>
    <message>
        <source>The %1 is left out, because it would be too small or less than 3 mm from another line.</source>
        <translation>%1: 너무 작거나 다른 선과 3 mm보다 가까워지므로 뺐습니다.</translation>
    </message>
    <message>
        <source>The name %1 is left out, because there is no room for its braille.</source>
        <translation>이름 %1: 점자를 넣을 자리가 없어 뺐습니다.</translation>
    </message>
</context>
<context>
    <name>TakePart</name>
    <message>
        <source>What to record</source>
        <translation>무엇을 녹음할지</translation>
    </message>
    <message>
        <source>Finish the recording</source>
        <translation>녹음 마치기</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>녹음</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>계속</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>일시 정지</translation>
    </message>
    <message>
        <source>Throw away…</source>
        <translation>버리기…</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>보관하기</translation>
    </message>
    <message>
        <source>Yes, throw it away</source>
        <translation>예, 버립니다</translation>
    </message>
    <message>
        <source>Add a sound file…</source>
        <translation>소리 파일 추가…</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Loudness</source>
        <translation>소리 크기</translation>
    </message>
</context>
<context>
    <name>TpButton</name>
    <message>
        <source>%1, not available</source>
        <translation>%1, 사용할 수 없음</translation>
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
        <translation>%1, %3개 중 %2번째</translation>
    </message>
</context>
<context>
    <name>TrimPart</name>
    <message>
        <source>Start of the part to keep</source>
        <translation>남길 부분의 시작</translation>
    </message>
    <message>
        <source>End of the part to keep</source>
        <translation>남길 부분의 끝</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>멈춤</translation>
    </message>
    <message>
        <source>Play the part to keep</source>
        <translation>남길 부분 듣기</translation>
    </message>
    <message>
        <source>Trim to this part</source>
        <translation>남길 부분만 두고 자르기</translation>
    </message>
    <message>
        <source>The rest can be brought back with Undo.</source>
        <translation>잘라낸 부분은 되돌리기로 되살릴 수 있습니다.</translation>
    </message>
    <message>
        <source>Keep all of it</source>
        <translation>모두 남기기</translation>
    </message>
</context>
<context>
    <name>UndoBar</name>
    <message>
        <source>Undo: %1</source>
        <translation>되돌리기: %1</translation>
    </message>
    <message>
        <source>Key: Control Z</source>
        <translation>Ctrl Z 키</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>다시 실행: %1</translation>
    </message>
    <message>
        <source>Key: Control Shift Z</source>
        <translation>Ctrl Shift Z 키</translation>
    </message>
</context>
<context>
    <name>WordsPane</name>
    <message>
        <source>Photograph</source>
        <translation>사진</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>정보</translation>
    </message>
</context>
<context>
    <name>tp::BrowseAlbum</name>
    <message>
        <source>There is no album yet. Choose the folders of your photographs on the settings page, or import photographs.</source>
        <translation>아직 앨범이 없습니다. 설정 페이지에서 사진 폴더를 고르거나 사진을 가져오세요.</translation>
    </message>
    <message>
        <source>Looking for photographs in your folders.</source>
        <translation>폴더에서 사진을 찾는 중입니다.</translation>
    </message>
    <message>
        <source>There is no photograph in your folders yet. Import some, or choose other folders on the settings page.</source>
        <translation>폴더에 아직 사진이 없습니다. 사진을 가져오거나, 설정 페이지에서 다른 폴더를 고르세요.</translation>
    </message>
    <message>
        <source>Looking for what is new in your folders</source>
        <translation>폴더에서 새로운 것을 찾는 중</translation>
    </message>
    <message>
        <source>Reading new photographs, %1 of %2</source>
        <translation>새 사진을 읽는 중, %2장 중 %1장</translation>
    </message>
    <message>
        <source>%1, about %2 left</source>
        <comment>progress, and a time</comment>
        <translation>%1, 약 %2 남음</translation>
    </message>
</context>
<context>
    <name>tp::BrowseDetails</name>
    <message>
        <source>%1 is gone from this list. Now: %2</source>
        <translation>%1: 이 목록에서 사라졌습니다. 현재: %2</translation>
    </message>
</context>
<context>
    <name>tp::BrowseLists</name>
    <message>
        <source>People</source>
        <translation>사람</translation>
    </message>
    <message>
        <source>Years</source>
        <translation>연도</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>장소</translation>
    </message>
    <message>
        <source>Keywords</source>
        <translation>키워드</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>검색</translation>
    </message>
    <message>
        <source>There is no photograph of that any more.</source>
        <translation>그에 해당하는 사진이 더는 없습니다.</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <comment>list, place in it, summary</comment>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>These are all photographs; there is no list above them.</source>
        <translation>이것이 모든 사진이며, 상위 목록은 없습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s)</source>
        <translation>
            <numerusform>사진 %n장</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n year(s)</source>
        <translation>
            <numerusform>연도 %n개</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n person(s)</source>
        <translation>
            <numerusform>%n명</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n place(s)</source>
        <translation>
            <numerusform>장소 %n곳</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n keyword(s)</source>
        <translation>
            <numerusform>키워드 %n개</numerusform>
        </translation>
    </message>
    <message>
        <source>The first %1</source>
        <comment>of a long list</comment>
        <translation>처음 %1개</translation>
    </message>
    <message>
        <source>Show more</source>
        <translation>더 보기</translation>
    </message>
    <message>
        <source>person, %1</source>
        <translation>사람, %1</translation>
    </message>
    <message>
        <source>place, %1</source>
        <translation>장소, %1</translation>
    </message>
    <message>
        <source>keyword, %1</source>
        <translation>키워드, %1</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s) or more</source>
        <translation>
            <numerusform>사진 %n장 이상</numerusform>
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
            <numerusform>제안 %n개</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>a row and what belongs to it</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Go to a row first.</source>
        <translation>먼저 목록의 줄로 이동하세요.</translation>
    </message>
    <message>
        <source>Found: %1</source>
        <comment>a search</comment>
        <translation>검색 결과: %1</translation>
    </message>
    <message>
        <source>%1.</source>
        <comment>what was found</comment>
        <translation>%1.</translation>
    </message>
    <message>
        <source>There is no letter to take away.</source>
        <translation>지울 글자가 없습니다.</translation>
    </message>
    <message>
        <source>Nothing is typed any more.</source>
        <translation>입력한 글자가 없습니다.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <comment>what is typed, what was found</comment>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>Search. Type a name, a place or a word, or move a finger over the letters and lift it on one. The arrow keys go through what is found.</source>
        <translation>검색. 이름, 장소 또는 낱말을 입력하거나, 손가락으로 글자 위를 지나가다 원하는 글자에서 떼세요. 화살표 키로 찾은 것을 살펴봅니다.</translation>
    </message>
    <message>
        <source>Search for %1: %2.</source>
        <translation>검색어 %1: %2.</translation>
    </message>
    <message>
        <source>%1: there are none yet.</source>
        <comment>a list</comment>
        <translation>%1: 아직 없습니다.</translation>
    </message>
    <message>
        <source>%1: %2. Choose one with the arrow keys and Return.</source>
        <comment>a list, how many</comment>
        <translation>%1: %2. 화살표 키로 고르고 엔터 키를 누르세요.</translation>
    </message>
</context>
<context>
    <name>tp::BrowsePlayback</name>
    <message>
        <source>This photograph has no recordings yet.</source>
        <translation>이 사진에는 아직 녹음이 없습니다.</translation>
    </message>
    <message>
        <source>%1, %2 of %3</source>
        <comment>a recording, and times in it</comment>
        <translation>%1, %3 중 %2</translation>
    </message>
    <message>
        <source>Speed %1</source>
        <comment>of recordings</comment>
        <translation>속도 %1배</translation>
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
        <source>Swipe or use the arrow keys to go on; double tap or press Return to hear.</source>
        <translation>화면을 쓸거나 화살표 키를 눌러 이동하고, 두 번 두드리거나 엔터 키를 눌러 들으세요.</translation>
    </message>
    <message>
        <source>Swipe or use the arrow keys to go on.</source>
        <translation>화면을 쓸거나 화살표 키를 눌러 이동하세요.</translation>
    </message>
    <message>
        <source>Your photographs, %1: %2 %3</source>
        <comment>place, summary, what can be done</comment>
        <translation>내 사진, %1: %2 %3</translation>
    </message>
    <message>
        <source>%1 Paused: %2, at %3.</source>
        <comment>where one is; the recording and the time in it</comment>
        <translation>%1 일시 정지됨: %2, 위치 %3.</translation>
    </message>
    <message>
        <source>Left and right: previous and next photograph. Up and down: what is known of it. Return: hear the recordings, or pause. Escape: stop. Plus and minus: faster and slower. Home and End: first and last photograph. S: search. P: people. Y: years. L: places. K: keywords. R: surprise me. A: all photographs. Backspace: back. E: feel the face. C: look after this photograph. W: where am I. H: these keys. A swipe goes the way of its arrow key, a double tap plays, two fingers stop, a Z of two fingers goes back, three fingers tell where you are.</source>
        <translation>왼쪽과 오른쪽 화살표: 이전 사진과 다음 사진. 위와 아래 화살표: 사진에 대해 알려진 내용. 엔터 키: 녹음 듣기 또는 일시 정지. Escape 키: 멈춤. 더하기와 빼기: 빠르게와 느리게. 홈과 엔드 키: 첫 사진과 마지막 사진. S: 검색. P: 사람. Y: 연도. L: 장소. K: 핵심어. R: 아무 사진이나. A: 모든 사진. 백스페이스: 뒤로. E: 얼굴 만지기. C: 이 사진 관리. W: 지금 위치. H: 이 키 안내. 쓸어 넘기기는 같은 방향의 화살표 키와 같고, 두 번 두드리면 재생하고, 두 손가락은 멈추고, 두 손가락으로 Z를 그리면 뒤로 가고, 세 손가락은 지금 위치를 알려 줍니다.</translation>
    </message>
    <message>
        <source>Your photographs.</source>
        <translation>내 사진.</translation>
    </message>
</context>
<context>
    <name>tp::BrowseTrail</name>
    <message>
        <source>All photographs</source>
        <translation>모든 사진</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>a place in a list</comment>
        <translation>%2개 중 %1번째</translation>
    </message>
    <message>
        <source>This is the last photograph.</source>
        <translation>마지막 사진입니다.</translation>
    </message>
    <message>
        <source>This is the first photograph.</source>
        <translation>첫 번째 사진입니다.</translation>
    </message>
</context>
<context>
    <name>tp::CareSession</name>
    <message>
        <source>Care for the album. It has no folder yet. Import photographs, and choose where they are kept.</source>
        <translation>앨범 관리. 아직 폴더가 없습니다. 사진을 가져오고, 사진을 둘 곳을 고르세요.</translation>
    </message>
    <message>
        <source>Care for the album. %1 is open: its faces, recordings and description.</source>
        <translation>앨범 관리. %1 사진이 열려 있습니다. 얼굴, 녹음, 설명을 다룰 수 있습니다.</translation>
    </message>
    <message>
        <source>Care for the album. %1 Choose one, or import more.</source>
        <translation>앨범 관리. %1 사진을 하나 고르거나 더 가져오세요.</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s).</source>
        <translation>
            <numerusform>사진 %n장.</numerusform>
        </translation>
    </message>
    <message>
        <source>Deleted: %1. Undo brings it back.</source>
        <translation>삭제했습니다: %1. 되돌리기로 되살릴 수 있습니다.</translation>
    </message>
    <message>
        <source>Undone: %1.</source>
        <translation>되돌렸습니다: %1.</translation>
    </message>
    <message>
        <source>Redone: %1.</source>
        <translation>다시 실행했습니다: %1.</translation>
    </message>
    <message>
        <source>No folder was chosen.</source>
        <translation>폴더를 고르지 않았습니다.</translation>
    </message>
    <message>
        <source>A recording is being made. Finish it first.</source>
        <translation>녹음하는 중입니다. 먼저 녹음을 끝내세요.</translation>
    </message>
</context>
<context>
    <name>tp::DescriptionCare</name>
    <message>
        <source>The description is saved.</source>
        <translation>설명이 저장되었습니다.</translation>
    </message>
</context>
<context>
    <name>tp::DeviceSettings</name>
    <message>
        <source>%1, over USB (HID)</source>
        <translation>%1, USB (HID) 연결</translation>
    </message>
    <message>
        <source>%1, over USB (bulk)</source>
        <translation>%1, USB (벌크) 연결</translation>
    </message>
    <message>
        <source>None: sound, and a drawn finger</source>
        <translation>없음: 소리와 화면의 손가락</translation>
    </message>
    <message>
        <source>%1, not plugged in</source>
        <translation>%1, 연결되지 않음</translation>
    </message>
    <message>
        <source>Calibrated: misses by %1 millimetres on average.</source>
        <translation>보정됨: 평균 %1밀리미터 어긋납니다.</translation>
    </message>
    <message>
        <source>Not calibrated. It may stand beside the screen; to lie on it, it must be calibrated.</source>
        <translation>보정되지 않았습니다. 화면 옆에 두고 쓸 수 있습니다. 화면 위에 올려놓으려면 보정해야 합니다.</translation>
    </message>
    <message>
        <source>No force device is plugged in. Plug one in; it is found by itself.</source>
        <translation>연결된 힘 장치가 없습니다. 장치를 꽂으면 저절로 찾습니다.</translation>
    </message>
    <message>
        <source>No force device is chosen. Choose one above.</source>
        <translation>힘 장치를 고르지 않았습니다. 위에서 고르세요.</translation>
    </message>
    <message>
        <source>The strongest force, %1 newtons: to the right, then to the left. Escape ends it.</source>
        <translation>가장 강한 힘, %1뉴턴입니다. 오른쪽으로, 그다음 왼쪽으로 당깁니다. Escape 키로 끝냅니다.</translation>
    </message>
    <message>
        <source>Calibration. The device lies on the screen; put a finger into it, so that it touches the screen. Escape ends it. %1</source>
        <translation>보정을 시작합니다. 장치를 화면 위에 놓고, 손가락을 장치에 넣어 화면에 닿게 하세요. Escape 키로 끝냅니다. %1</translation>
    </message>
    <message>
        <source>That was the strongest force.</source>
        <translation>가장 강한 힘이었습니다.</translation>
    </message>
    <message>
        <source>Touch the top left corner and keep still until I speak.</source>
        <translation>왼쪽 위 모서리를 누르고 제가 말할 때까지 가만히 계세요.</translation>
    </message>
    <message>
        <source>Now the top right corner.</source>
        <translation>이제 오른쪽 위 모서리입니다.</translation>
    </message>
    <message>
        <source>Now the bottom right corner.</source>
        <translation>이제 오른쪽 아래 모서리입니다.</translation>
    </message>
    <message>
        <source>Now the bottom left corner.</source>
        <translation>이제 왼쪽 아래 모서리입니다.</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>바뀐 것은 없습니다.</translation>
    </message>
    <message>
        <source>The calibration misses your touches by %1 millimetres on average, and at most %2 are allowed. See that the device does not slip on the screen, keep still at each corner, and calibrate again.</source>
        <translation>보정 결과가 누른 자리와 평균 %1밀리미터 어긋납니다. 최대 %2까지 허용됩니다. 장치가 화면에서 미끄러지지 않게 하고, 모서리마다 가만히 있으면서 다시 보정하세요.</translation>
    </message>
    <message>
        <source>The device and the screen do not move alike. Calibrate again with the finger in the device, and no other on the screen.</source>
        <translation>장치와 화면의 움직임이 서로 맞지 않습니다. 손가락을 장치에 넣고, 다른 손가락은 화면에서 떼고 다시 보정하세요.</translation>
    </message>
    <message>
        <source>Calibrated. It misses by %1 millimetres on average, and is kept for this device.</source>
        <translation>보정했습니다. 평균 %1밀리미터 어긋나며, 이 장치의 보정값으로 저장했습니다.</translation>
    </message>
    <message>
        <source>Calibration ended. Nothing was changed.</source>
        <translation>보정을 끝냈습니다. 바뀐 것은 없습니다.</translation>
    </message>
    <message>
        <source>Stopped. The force is off.</source>
        <translation>멈췄습니다. 힘이 꺼졌습니다.</translation>
    </message>
    <message>
        <source>The device is homed: it knows where its handle is.</source>
        <translation>기준점을 맞추었습니다. 이제 장치가 손잡이의 위치를 압니다.</translation>
    </message>
    <message>
        <source>This device knows its newtons itself; only force sticks are measured.</source>
        <translation>이 장치는 자기 뉴턴을 스스로 압니다. 힘 스틱만 잽니다.</translation>
    </message>
    <message>
        <source>%1 Escape ends it.</source>
        <translation>%1 Escape 키로 끝냅니다.</translation>
    </message>
    <message>
        <source>That is too little to be read well. The stick pulls twice as strongly now: weigh again.</source>
        <translation>너무 적어 잘 읽을 수 없습니다. 이제 스틱이 두 배로 세게 당깁니다. 다시 다십시오.</translation>
    </message>
    <message>
        <source>The stick is measured: %1 newtons at most. That is kept for this stick.</source>
        <translation>스틱을 쟀습니다: 최대 %1뉴턴. 이 스틱의 값으로 저장했습니다.</translation>
    </message>
    <message>
        <source>Measurement ended. The force is off. Nothing was changed.</source>
        <translation>재기를 끝냈습니다. 힘이 꺼졌습니다. 바뀐 것은 없습니다.</translation>
    </message>
</context>
<context>
    <name>tp::ExploreChoices</name>
    <message>
        <source>None</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>Sonar</source>
        <translation>소나</translation>
    </message>
    <message>
        <source>Clock voice</source>
        <translation>몇 시 방향인지 말하기</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>둘 다</translation>
    </message>
    <message>
        <source>Guide: %1.</source>
        <translation>길잡이: %1.</translation>
    </message>
</context>
<context>
    <name>tp::ExploreDevice</name>
    <message>
        <source>The force is on.</source>
        <translation>힘이 켜졌습니다.</translation>
    </message>
    <message>
        <source>The device is ready. Its force is on.</source>
        <translation>장치가 준비되었습니다. 힘이 켜졌습니다.</translation>
    </message>
    <message>
        <source>The device is ready. Its force is off. Press Enter to switch it on.</source>
        <translation>장치가 준비되었습니다. 힘이 꺼져 있습니다. 엔터 키를 누르면 켜집니다.</translation>
    </message>
    <message>
        <source>The picture is too small or too large on the screen to be felt where it is seen. The device feels it in its true size.</source>
        <translation>사진이 화면에서 너무 작거나 커서 보이는 자리에서 느낄 수 없습니다. 장치는 원래 크기로 느끼게 합니다.</translation>
    </message>
    <message>
        <source>Device: %1. Its force is on.</source>
        <translation>장치: %1. 힘이 켜졌습니다.</translation>
    </message>
    <message>
        <source>Device: %1. Its force is off. Press Enter to switch it on.</source>
        <translation>장치: %1. 힘이 꺼져 있습니다. 엔터 키를 누르면 켜집니다.</translation>
    </message>
    <message>
        <source>%1 Until then the force is only drawn.</source>
        <translation>%1 그때까지 힘은 그림으로만 나타납니다.</translation>
    </message>
</context>
<context>
    <name>tp::ExploreEar</name>
    <message numerus="yes">
        <source>%1 o&apos;clock, %n millimetre(s)</source>
        <translation>
            <numerusform>%1시 방향, %n밀리미터</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::ExploreFinger</name>
    <message>
        <source>There is nothing to feel here.</source>
        <translation>여기에는 만질 것이 없습니다.</translation>
    </message>
</context>
<context>
    <name>tp::ExploreHand</name>
    <message>
        <source>Move the finger with the device.</source>
        <translation>장치로 손가락을 움직이세요.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 o&apos;clock, %n millimetre(s).</source>
        <translation>
            <numerusform>%1: %2시 방향, %n밀리미터.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::ExploreSession</name>
    <message>
        <source>Explore. %1 Move a finger over the picture; W tells where it is.</source>
        <translation>살펴보기. %1 사진 위에서 손가락을 움직이세요. W를 누르면 손가락의 위치를 말해 줍니다.</translation>
    </message>
    <message>
        <source>Explore. %1</source>
        <translation>살펴보기. %1</translation>
    </message>
    <message>
        <source>Only a photograph that is a file on this computer can be opened.</source>
        <translation>이 컴퓨터에 파일로 있는 사진만 열 수 있습니다.</translation>
    </message>
    <message>
        <source>Stopped. The force is off. Press Enter to switch it on.</source>
        <translation>멈췄습니다. 힘이 꺼져 있습니다. 엔터 키를 누르면 켜집니다.</translation>
    </message>
</context>
<context>
    <name>tp::ExploreTour</name>
    <message>
        <source>The force is off. Press Enter to switch it on.</source>
        <translation>힘이 꺼져 있습니다. 엔터 키를 누르면 켜집니다.</translation>
    </message>
    <message>
        <source>Tour round the %1.</source>
        <translation>%1 둘레를 안내합니다.</translation>
    </message>
    <message numerus="yes">
        <source>Tour of %1: %n feature(s). %2.</source>
        <translation>
            <numerusform>%1 안내, 부위 %n개. %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Tour finished.</source>
        <translation>안내를 마쳤습니다.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>Tour ended.</source>
        <translation>안내가 끝났습니다.</translation>
    </message>
</context>
<context>
    <name>tp::ExploreView</name>
    <message>
        <source>the face</source>
        <translation>얼굴</translation>
    </message>
    <message>
        <source>face %1</source>
        <translation>%1번 얼굴</translation>
    </message>
    <message>
        <source>There is no photograph yet. Press O, or the button Open photograph, to choose one.</source>
        <translation>아직 사진이 없습니다. O를 누르거나 사진 열기 버튼을 눌러 사진을 고르세요.</translation>
    </message>
    <message>
        <source>Looking for faces…</source>
        <translation>얼굴을 찾는 중…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Stopped looking. Press O to open a photograph.</source>
        <translation>찾기를 멈췄습니다. O를 눌러 사진을 여세요.</translation>
    </message>
    <message>
        <source>Stopped looking. %1 is open again. The force is off. Press Enter to switch it on.</source>
        <translation>찾기를 멈췄습니다. %1 사진이 다시 열렸습니다. 힘이 꺼져 있습니다. 엔터 키를 누르면 켜집니다.</translation>
    </message>
    <message>
        <source>Stopped looking. %1 is open again.</source>
        <translation>찾기를 멈췄습니다. %1 사진이 다시 열렸습니다.</translation>
    </message>
    <message>
        <source>face</source>
        <translation>얼굴</translation>
    </message>
</context>
<context>
    <name>tp::ExploreWalk</name>
    <message>
        <source>Your newest photograph with a face.</source>
        <translation>얼굴이 있는 가장 최근 사진입니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s) without a face passed over.</source>
        <translation>
            <numerusform>얼굴이 없는 사진 %n장을 건너뛰었습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1.</source>
        <comment>a photograph&apos;s name</comment>
        <translation>%1.</translation>
    </message>
    <message numerus="yes">
        <source>Looking further: %n photograph(s) without a face so far.</source>
        <translation>
            <numerusform>계속 찾는 중입니다. 지금까지 얼굴이 없는 사진 %n장.</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no face on any photograph of the album.</source>
        <translation>앨범에 얼굴이 있는 사진이 없습니다.</translation>
    </message>
    <message>
        <source>No photograph with a face comes after this one.</source>
        <translation>이 사진 다음에는 얼굴이 있는 사진이 없습니다.</translation>
    </message>
    <message>
        <source>No photograph with a face comes before this one.</source>
        <translation>이 사진 앞에는 얼굴이 있는 사진이 없습니다.</translation>
    </message>
</context>
<context>
    <name>tp::ExploreZoom</name>
    <message>
        <source>Zoomed out to the whole face.</source>
        <translation>얼굴 전체가 보이도록 축소했습니다.</translation>
    </message>
    <message numerus="yes">
        <source>Zoomed out to all %n face(s).</source>
        <translation>
            <numerusform>얼굴 %n개가 모두 보이도록 축소했습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>Zoomed to the eyes of %1.</source>
        <translation>%1의 눈을 확대했습니다.</translation>
    </message>
    <message>
        <source>Zoomed to the eyes.</source>
        <translation>눈을 확대했습니다.</translation>
    </message>
    <message>
        <source>Zoomed to the left eye of %1.</source>
        <translation>%1의 왼쪽 눈을 확대했습니다.</translation>
    </message>
    <message>
        <source>Zoomed to the left eye.</source>
        <translation>왼쪽 눈을 확대했습니다.</translation>
    </message>
    <message>
        <source>Zoomed to the right eye of %1.</source>
        <translation>%1의 오른쪽 눈을 확대했습니다.</translation>
    </message>
    <message>
        <source>Zoomed to the right eye.</source>
        <translation>오른쪽 눈을 확대했습니다.</translation>
    </message>
    <message>
        <source>Zoomed to the mouth of %1.</source>
        <translation>%1의 입을 확대했습니다.</translation>
    </message>
    <message>
        <source>Zoomed to the mouth.</source>
        <translation>입을 확대했습니다.</translation>
    </message>
    <message>
        <source>Zoomed to %1.</source>
        <translation>%1에 맞춰 확대했습니다.</translation>
    </message>
    <message>
        <source>This part is too small in the picture to zoom to it.</source>
        <translation>이 부분은 사진에서 너무 작아 확대할 수 없습니다.</translation>
    </message>
    <message>
        <source>%1 %2.</source>
        <translation>%1 %2.</translation>
    </message>
    <message>
        <source>This is the whole picture.</source>
        <translation>사진 전체가 보입니다.</translation>
    </message>
    <message>
        <source>There is nothing nearer to zoom to here.</source>
        <translation>여기에는 더 확대할 것이 없습니다.</translation>
    </message>
</context>
<context>
    <name>tp::ExtractionWords</name>
    <message>
        <source>One face.</source>
        <translation>얼굴 하나.</translation>
    </message>
    <message>
        <source>Two faces.</source>
        <translation>얼굴 둘.</translation>
    </message>
    <message>
        <source>Three faces.</source>
        <translation>얼굴 셋.</translation>
    </message>
    <message>
        <source>Four faces.</source>
        <translation>얼굴 넷.</translation>
    </message>
    <message numerus="yes">
        <source>%n face(s).</source>
        <translation>
            <numerusform>얼굴 %n개.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <comment>the end of a list</comment>
        <translation>%1 및 %2</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>eyes</source>
        <translation>눈</translation>
    </message>
    <message>
        <source>mouth</source>
        <translation>입</translation>
    </message>
    <message>
        <source>outline</source>
        <translation>얼굴 윤곽</translation>
    </message>
    <message>
        <source>brows</source>
        <translation>눈썹</translation>
    </message>
    <message>
        <source>nose</source>
        <translation>코</translation>
    </message>
    <message>
        <source>irises</source>
        <translation>홍채</translation>
    </message>
    <message>
        <source>%1.</source>
        <comment>who is on the picture</comment>
        <translation>%1.</translation>
    </message>
    <message>
        <source>%1 can be felt.</source>
        <translation>만질 수 있는 곳: %1.</translation>
    </message>
    <message>
        <source>%1 of each can be felt.</source>
        <translation>각각 만질 수 있는 곳: %1.</translation>
    </message>
</context>
<context>
    <name>tp::FaceCare</name>
    <message>
        <source>Face without a name</source>
        <translation>이름 없는 얼굴</translation>
    </message>
    <message>
        <source>Looking for faces…</source>
        <translation>얼굴을 찾는 중…</translation>
    </message>
    <message>
        <source>No face was found on this photograph.</source>
        <translation>이 사진에서 얼굴을 찾지 못했습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n face(s)</source>
        <translation>
            <numerusform>얼굴 %n개</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, all with a name.</source>
        <translation>%1, 모두 이름이 있습니다.</translation>
    </message>
    <message>
        <source>%1, %2.</source>
        <translation>%1, %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n without a name</source>
        <translation>
            <numerusform>이름 없는 얼굴 %n개</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2 of %3. Type a name or choose one below.</source>
        <translation>%1, %3개 중 %2번째. 이름을 입력하거나 아래에서 고르세요.</translation>
    </message>
    <message>
        <source>This face has no name now.</source>
        <translation>이제 이 얼굴에는 이름이 없습니다.</translation>
    </message>
    <message>
        <source>Saved: %1.</source>
        <translation>저장했습니다: %1.</translation>
    </message>
    <message>
        <source>%1 Who is the next face?</source>
        <translation>%1 다음 얼굴은 누구인가요?</translation>
    </message>
    <message>
        <source>Saved: %1 is read as the page is.</source>
        <translation>저장했습니다: %1, 페이지와 같은 언어로 읽습니다.</translation>
    </message>
    <message>
        <source>Saved: %1. The name is read as %2.</source>
        <translation>저장했습니다: %1. 이름을 읽는 언어: %2.</translation>
    </message>
    <message>
        <source>One face, with a name.</source>
        <translation>얼굴 한 개, 이름이 있습니다.</translation>
    </message>
    <message>
        <source>One face, without a name.</source>
        <translation>얼굴 한 개, 이름이 없습니다.</translation>
    </message>
</context>
<context>
    <name>tp::FeatureLabels</name>
    <message>
        <source>left eye</source>
        <translation>왼쪽 눈</translation>
    </message>
    <message>
        <source>right eye</source>
        <translation>오른쪽 눈</translation>
    </message>
    <message>
        <source>lips</source>
        <translation>입술</translation>
    </message>
    <message>
        <source>mouth opening</source>
        <translation>입 벌어진 곳</translation>
    </message>
    <message>
        <source>face outline</source>
        <translation>얼굴 윤곽</translation>
    </message>
    <message>
        <source>left brow</source>
        <translation>왼쪽 눈썹</translation>
    </message>
    <message>
        <source>right brow</source>
        <translation>오른쪽 눈썹</translation>
    </message>
    <message>
        <source>nose</source>
        <translation>코</translation>
    </message>
    <message>
        <source>left iris</source>
        <translation>왼쪽 홍채</translation>
    </message>
    <message>
        <source>right iris</source>
        <translation>오른쪽 홍채</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>left eye of Anna</comment>
        <translation>%2의 %1</translation>
    </message>
    <message>
        <source>%1 of face %2</source>
        <comment>left eye of face 2</comment>
        <translation>%2번 얼굴의 %1</translation>
    </message>
</context>
<context>
    <name>tp::FeelingSettings</name>
    <message>
        <source>Nothing</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>Beeps</source>
        <translation>삐 소리</translation>
    </message>
    <message>
        <source>Spoken clock directions</source>
        <translation>몇 시 방향인지 말하기</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>둘 다</translation>
    </message>
    <message>
        <source>what guides the finger</source>
        <translation>손가락을 이끄는 방법</translation>
    </message>
    <message>
        <source>the strongest force</source>
        <translation>최대 힘</translation>
    </message>
    <message>
        <source>At most %1 newtons.</source>
        <translation>최대 %1뉴턴.</translation>
    </message>
    <message>
        <source>the force device</source>
        <translation>힘 장치</translation>
    </message>
    <message>
        <source>Force device: %1.</source>
        <translation>힘 장치: %1.</translation>
    </message>
    <message>
        <source>brows</source>
        <translation>눈썹</translation>
    </message>
    <message>
        <source>Brows are felt.</source>
        <translation>눈썹을 만질 수 있습니다.</translation>
    </message>
    <message>
        <source>Brows are not felt.</source>
        <translation>눈썹은 만져지지 않습니다.</translation>
    </message>
    <message>
        <source>the nose</source>
        <translation>코</translation>
    </message>
    <message>
        <source>The nose is felt.</source>
        <translation>코를 만질 수 있습니다.</translation>
    </message>
    <message>
        <source>The nose is not felt.</source>
        <translation>코는 만져지지 않습니다.</translation>
    </message>
    <message>
        <source>irises</source>
        <translation>홍채</translation>
    </message>
    <message>
        <source>Irises are felt.</source>
        <translation>홍채를 만질 수 있습니다.</translation>
    </message>
    <message>
        <source>Irises are not felt.</source>
        <translation>홍채는 만져지지 않습니다.</translation>
    </message>
</context>
<context>
    <name>tp::FocusText</name>
    <message>
        <source>button</source>
        <translation>버튼</translation>
    </message>
    <message>
        <source>switch</source>
        <translation>스위치</translation>
    </message>
    <message>
        <source>choice</source>
        <translation>선택 항목</translation>
    </message>
    <message>
        <source>slider</source>
        <translation>슬라이더</translation>
    </message>
    <message>
        <source>text field</source>
        <translation>입력란</translation>
    </message>
    <message>
        <source>on</source>
        <translation>켜짐</translation>
    </message>
    <message>
        <source>off</source>
        <translation>꺼짐</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>선택됨</translation>
    </message>
</context>
<context>
    <name>tp::FolderChooser</name>
    <message>
        <source>no photographs in this folder itself</source>
        <translation>이 폴더 안에 바로 있는 사진은 없음</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s) in this folder itself</source>
        <translation>
            <numerusform>이 폴더 안에 바로 있는 사진 %n장</numerusform>
        </translation>
    </message>
    <message>
        <source>The folder %1 cannot be read.</source>
        <translation>폴더를 읽을 수 없습니다: %1.</translation>
    </message>
    <message>
        <source>the whole computer</source>
        <translation>컴퓨터 전체</translation>
    </message>
    <message>
        <source>no folders below it</source>
        <translation>하위 폴더 없음</translation>
    </message>
    <message numerus="yes">
        <source>%n folder(s) below it</source>
        <translation>
            <numerusform>하위 폴더 %n개</numerusform>
        </translation>
    </message>
    <message>
        <source>Folder %1: %2, %3.</source>
        <translation>폴더 %1: %2, %3.</translation>
    </message>
</context>
<context>
    <name>tp::ImportCare</name>
    <message>
        <source>Looking for photographs…</source>
        <translation>사진을 찾는 중…</translation>
    </message>
    <message>
        <source>An import is under way. Wait for its end, or stop it first.</source>
        <translation>이미 가져오는 중입니다. 끝날 때까지 기다리거나 먼저 중단하세요.</translation>
    </message>
    <message>
        <source>Only photographs and folders on this computer can be imported.</source>
        <translation>이 컴퓨터에 있는 사진과 폴더만 가져올 수 있습니다.</translation>
    </message>
    <message>
        <source>Choose the folder in which the album is to lie. The photographs are copied into it.</source>
        <translation>앨범을 둘 폴더를 고르세요. 사진이 그 폴더로 복사됩니다.</translation>
    </message>
    <message>
        <source>Importing…</source>
        <translation>가져오는 중…</translation>
    </message>
    <message>
        <source>The album needs a folder on this computer.</source>
        <translation>앨범에는 이 컴퓨터에 있는 폴더가 필요합니다.</translation>
    </message>
    <message>
        <source>The album has the folder %1 now.</source>
        <translation>이제 앨범의 폴더는 다음과 같습니다: %1.</translation>
    </message>
    <message>
        <source>Stopping after this photograph.</source>
        <translation>이 사진까지만 가져오고 멈춥니다.</translation>
    </message>
    <message>
        <source>The import goes on.</source>
        <translation>가져오기를 계속합니다.</translation>
    </message>
    <message>
        <source>The import is not gone on with. What it brought stays.</source>
        <translation>가져오기를 그만둡니다. 이미 가져온 사진은 남습니다.</translation>
    </message>
</context>
<context>
    <name>tp::KeeperSteps</name>
    <message>
        <source>There is nothing to undo.</source>
        <translation>되돌릴 것이 없습니다.</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>다시 실행할 것이 없습니다.</translation>
    </message>
</context>
<context>
    <name>tp::LabActivity</name>
    <message>
        <source>Nothing can be changed during a recording. Escape ends it.</source>
        <translation>기록하는 동안에는 아무것도 바꿀 수 없습니다. Escape 키로 기록을 끝냅니다.</translation>
    </message>
    <message>
        <source>Nothing can be changed during a replay. Escape ends it.</source>
        <translation>다시 재생하는 동안에는 아무것도 바꿀 수 없습니다. Escape 키로 재생을 끝냅니다.</translation>
    </message>
</context>
<context>
    <name>tp::LabArchive</name>
    <message>
        <source>The folder %1 cannot be made: %2</source>
        <translation>폴더 %1: 만들 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The recording cannot be begun: %1</source>
        <translation>기록을 시작할 수 없습니다: %1</translation>
    </message>
    <message>
        <source>The recording is not whole, because the disk is full or this computer was too busy.</source>
        <translation>디스크가 가득 찼거나 컴퓨터가 너무 바빠서 기록이 온전하지 않습니다.</translation>
    </message>
    <message>
        <source>Recorded in %1; the parameters lie beside it.</source>
        <translation>기록한 파일: %1. 매개변수는 그 옆에 있습니다.</translation>
    </message>
    <message>
        <source>There is nothing to write yet. Start the servo first.</source>
        <translation>아직 저장할 것이 없습니다. 먼저 서보를 켜세요.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1: 쓸 수 없습니다. %2</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) are in %1; the parameters lie beside them.</source>
        <translation>
            <numerusform>%1: %n줄을 저장했습니다. 매개변수는 그 옆에 있습니다.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::LabDevices</name>
    <message>
        <source>Simulated: the mouse or a finger on the screen</source>
        <translation>모의 장치: 마우스나 화면 위의 손가락</translation>
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
        <translation>손가락 위치: %1. </translation>
    </message>
    <message>
        <source>No line pulls there.</source>
        <translation>그곳에서는 당기는 선이 없습니다.</translation>
    </message>
    <message>
        <source>%1 mm from %2; the law pulls with %3 newtons.</source>
        <translation>가까운 선 %2, 거리 %1 mm. 유도 법칙이 %3뉴턴으로 당깁니다.</translation>
    </message>
</context>
<context>
    <name>tp::LabReplayer</name>
    <message>
        <source>Reading %1.</source>
        <translation>읽는 중: %1.</translation>
    </message>
    <message>
        <source>%1 holds nothing.</source>
        <translation>%1: 비어 있습니다.</translation>
    </message>
    <message>
        <source>Replaying %1. Escape ends it.</source>
        <translation>다시 재생하는 중: %1. Escape 키로 끝냅니다.</translation>
    </message>
    <message>
        <source>The replay has ended. %1</source>
        <translation>다시 재생이 끝났습니다. %1</translation>
    </message>
</context>
<context>
    <name>tp::LabRun</name>
    <message>
        <source>Opening %1.</source>
        <translation>여는 중: %1.</translation>
    </message>
    <message>
        <source>Recording: %1. Escape ends it.</source>
        <translation>기록 중: %1. Escape 키로 끝냅니다.</translation>
    </message>
    <message>
        <source>The servo runs: %1. Escape stops it.</source>
        <translation>서보가 작동 중: %1. Escape 키로 멈춥니다.</translation>
    </message>
    <message>
        <source>Only a simulated device that runs can be made to hang.</source>
        <translation>실행 중인 모의 장치만 멈추게 할 수 있습니다.</translation>
    </message>
    <message>
        <source>The device hangs for 200 milliseconds.</source>
        <translation>장치가 200밀리초 동안 응답을 멈춥니다.</translation>
    </message>
</context>
<context>
    <name>tp::LabScene</name>
    <message>
        <source>Photograph</source>
        <translation>사진</translation>
    </message>
    <message>
        <source>Photograph %1</source>
        <translation>사진 %1</translation>
    </message>
    <message>
        <source>Circle, radius 40 mm</source>
        <translation>원, 반지름 40 mm</translation>
    </message>
    <message>
        <source>Triangle, 50 mm high</source>
        <translation>삼각형, 높이 50 mm</translation>
    </message>
    <message>
        <source>Curved path, 200 mm wide</source>
        <translation>굽은 길, 너비 200 mm</translation>
    </message>
    <message>
        <source>Force field of %1: colours and arrows from 0 to %2 newtons. The rule is 20 mm long.</source>
        <translation>힘의 장, %1: 색과 화살표는 0부터 %2뉴턴까지입니다. 자의 길이는 20 mm입니다.</translation>
    </message>
    <message>
        <source>Only a photograph that is a file on this computer can be opened.</source>
        <translation>이 컴퓨터에 파일로 있는 사진만 열 수 있습니다.</translation>
    </message>
    <message>
        <source>There is no photograph yet. Open one, or drop one on the page.</source>
        <translation>아직 사진이 없습니다. 사진을 열거나 페이지에 끌어다 놓으세요.</translation>
    </message>
    <message>
        <source>Looking for faces in %1.</source>
        <translation>얼굴을 찾는 중입니다: %1.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n line(s) can be felt.</source>
        <translation>
            <numerusform>%1: 만질 수 있는 선 %n개.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::LabSession</name>
    <message>
        <source>The lab. A finger on a simulated device, a force field, and everything that can be turned. Space on the surface starts the servo, Escape stops it.</source>
        <translation>실험실. 모의 장치 위의 손가락과 힘의 장을 다루며, 모든 값을 바꿀 수 있습니다. 터치 영역에서 스페이스바는 서보를 켜고, Escape 키는 멈춥니다.</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>멈췄습니다.</translation>
    </message>
</context>
<context>
    <name>tp::LabTeller</name>
    <message>
        <source>Nothing runs.</source>
        <translation>실행 중인 것이 없습니다.</translation>
    </message>
</context>
<context>
    <name>tp::LabTuning</name>
    <message>
        <source>Exact</source>
        <translation>정확한 법칙</translation>
    </message>
    <message>
        <source>Published Algorithm 1</source>
        <translation>논문의 알고리즘 1</translation>
    </message>
    <message>
        <source>the law</source>
        <translation>유도 법칙</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>%1: on.</source>
        <translation>%1: 켜짐.</translation>
    </message>
    <message>
        <source>%1: off.</source>
        <translation>%1: 꺼짐.</translation>
    </message>
    <message>
        <source>the reset</source>
        <translation>처음 상태로 돌리기</translation>
    </message>
    <message>
        <source>Law, servo, device and faults are as they were at first.</source>
        <translation>유도 법칙, 서보, 장치, 고장이 처음 상태로 돌아갔습니다.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>되돌릴 것이 없습니다.</translation>
    </message>
    <message>
        <source>Undone: %1.</source>
        <translation>되돌렸습니다: %1.</translation>
    </message>
</context>
<context>
    <name>tp::LookSettings</name>
    <message>
        <source>Somebody who listens and feels</source>
        <translation>듣고 만지는 사람</translation>
    </message>
    <message>
        <source>Somebody who looks after the album</source>
        <translation>앨범을 관리하는 사람</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>어둡게</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>밝게</translation>
    </message>
    <message>
        <source>Yellow on black</source>
        <translation>검은 바탕에 노란색</translation>
    </message>
    <message>
        <source>who uses the tablet</source>
        <translation>태블릿을 쓰는 사람</translation>
    </message>
    <message>
        <source>the colours</source>
        <translation>색</translation>
    </message>
    <message>
        <source>the size of text</source>
        <translation>글자 크기</translation>
    </message>
    <message>
        <source>Text at %1 percent.</source>
        <translation>글자 크기 %1퍼센트.</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>움직임</translation>
    </message>
    <message>
        <source>Pictures may move.</source>
        <translation>그림이 움직일 수 있습니다.</translation>
    </message>
    <message>
        <source>Nothing moves by itself.</source>
        <translation>아무것도 저절로 움직이지 않습니다.</translation>
    </message>
</context>
<context>
    <name>tp::MendDrag</name>
    <message>
        <source>the %1 was moved</source>
        <translation>%1 이동</translation>
    </message>
    <message>
        <source>a point of the %1 was moved</source>
        <translation>%1의 점 이동</translation>
    </message>
    <message>
        <source>%1 moved.</source>
        <translation>옮겼습니다: %1.</translation>
    </message>
    <message>
        <source>Put back.</source>
        <translation>제자리로 돌려놓았습니다.</translation>
    </message>
</context>
<context>
    <name>tp::MendEditing</name>
    <message>
        <source>the %1 was moved</source>
        <translation>%1 이동</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>a point of the %1 was moved</source>
        <translation>%1의 점 이동</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>No point is in hand. Tab goes from point to point.</source>
        <translation>선택된 점이 없습니다. 탭 키로 점 사이를 이동합니다.</translation>
    </message>
    <message>
        <source>a point of the %1 was added</source>
        <translation>%1의 점 추가</translation>
    </message>
    <message>
        <source>Added. %1: %2.</source>
        <translation>추가했습니다. %1: %2.</translation>
    </message>
    <message>
        <source>The %1 needs its last points. The whole feature can be removed.</source>
        <translation>%1: 남은 점이 모두 필요합니다. 부위 전체는 없앨 수 있습니다.</translation>
    </message>
    <message>
        <source>a point of the %1 was deleted</source>
        <translation>%1의 점 삭제</translation>
    </message>
    <message>
        <source>Deleted. In hand: %1.</source>
        <translation>삭제했습니다. 선택: %1.</translation>
    </message>
    <message>
        <source>This point can be no corner.</source>
        <translation>이 점은 모서리가 될 수 없습니다.</translation>
    </message>
    <message>
        <source>a point of the %1 was turned</source>
        <translation>%1의 점 종류 바꾸기</translation>
    </message>
    <message>
        <source>A corner now.</source>
        <translation>이제 모서리입니다.</translation>
    </message>
    <message>
        <source>Smooth now.</source>
        <translation>이제 매끄럽습니다.</translation>
    </message>
    <message>
        <source>The %1 is as the program found it.</source>
        <translation>%1: 프로그램이 찾은 그대로입니다.</translation>
    </message>
    <message>
        <source>the %1 was reset</source>
        <translation>%1 처음 상태로 돌리기</translation>
    </message>
    <message>
        <source>The %1 is as the program found it again.</source>
        <translation>%1: 다시 프로그램이 찾은 대로입니다.</translation>
    </message>
    <message>
        <source>The %1 is gone again: the program did not find it.</source>
        <translation>%1: 프로그램이 찾지 못했던 부위이므로 다시 없어졌습니다.</translation>
    </message>
    <message>
        <source>The %1 is there already.</source>
        <translation>%1: 이미 있습니다.</translation>
    </message>
    <message>
        <source>the %1 was added</source>
        <translation>%1 추가</translation>
    </message>
    <message>
        <source>The %1 is there, as the program found it.</source>
        <translation>%1: 프로그램이 찾은 대로 추가했습니다.</translation>
    </message>
    <message>
        <source>The %1 was added in its usual shape. Move it into place.</source>
        <translation>%1: 보통 모양으로 추가했습니다. 제자리로 옮기세요.</translation>
    </message>
    <message>
        <source>the %1 was removed</source>
        <translation>%1 없애기</translation>
    </message>
    <message>
        <source>The %1 is removed. It will not be felt.</source>
        <translation>%1: 없앴습니다. 만져지지 않게 됩니다.</translation>
    </message>
    <message>
        <source>a face was added</source>
        <translation>얼굴 추가</translation>
    </message>
    <message>
        <source>A face of usual shape was added. Move its features into place.</source>
        <translation>보통 모양의 얼굴을 추가했습니다. 부위를 제자리로 옮기세요.</translation>
    </message>
</context>
<context>
    <name>tp::MendHistory</name>
    <message>
        <source>There is nothing to undo.</source>
        <translation>되돌릴 것이 없습니다.</translation>
    </message>
    <message>
        <source>Undone: %1.</source>
        <translation>되돌렸습니다: %1.</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>다시 실행할 것이 없습니다.</translation>
    </message>
    <message>
        <source>Redone: %1.</source>
        <translation>다시 실행했습니다: %1.</translation>
    </message>
</context>
<context>
    <name>tp::MendPreview</name>
    <message>
        <source>The force is shown.</source>
        <translation>힘을 보여 줍니다.</translation>
    </message>
    <message>
        <source>The force is hidden.</source>
        <translation>힘을 숨깁니다.</translation>
    </message>
</context>
<context>
    <name>tp::MendSaving</name>
    <message>
        <source>%1 Your work is kept here; nothing is lost.</source>
        <translation>%1 작업한 내용은 여기에 그대로 있으며, 잃은 것은 없습니다.</translation>
    </message>
    <message>
        <source>The contours are saved.</source>
        <translation>윤곽선이 저장되었습니다.</translation>
    </message>
    <message>
        <source>The contours are saved. Another program had changed them; what it wrote is kept as %1.</source>
        <translation>윤곽선이 저장되었습니다. 다른 프로그램이 윤곽선을 바꾸었으며, 그 내용은 다음 파일에 남겨 두었습니다: %1.</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>바뀐 것이 없습니다.</translation>
    </message>
    <message>
        <source>all changes were discarded</source>
        <translation>모든 변경 버리기</translation>
    </message>
    <message>
        <source>All changes are discarded: the contours are as they were opened.</source>
        <translation>모든 변경을 버렸습니다. 윤곽선은 열었을 때와 같습니다.</translation>
    </message>
</context>
<context>
    <name>tp::MendSelection</name>
    <message numerus="yes">
        <source>%1, %n point(s).</source>
        <translation>
            <numerusform>%1, 점 %n개.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: not there. It can be added.</source>
        <translation>%1: 없습니다. 추가할 수 있습니다.</translation>
    </message>
    <message>
        <source>The whole feature moves.</source>
        <translation>부위 전체가 움직입니다.</translation>
    </message>
    <message>
        <source>One point moves.</source>
        <translation>점 하나가 움직입니다.</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n point(s), none in hand.</source>
        <translation>
            <numerusform>%1, 점 %n개, 선택된 점 없음.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of the %2: %3.</source>
        <translation>%2, %1: %3.</translation>
    </message>
</context>
<context>
    <name>tp::MendSession</name>
    <message>
        <source>Only a photograph that is a file on this computer can be opened.</source>
        <translation>이 컴퓨터에 파일로 있는 사진만 열 수 있습니다.</translation>
    </message>
    <message>
        <source>Looking for faces…</source>
        <translation>얼굴을 찾는 중…</translation>
    </message>
    <message>
        <source>Here the contours of a photograph are mended. There is no photograph yet.</source>
        <translation>여기에서 사진의 윤곽선을 고칩니다. 아직 사진이 없습니다.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a photograph and what is wrong with it</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No face was found in %1. One of usual shape can be added and put in place.</source>
        <translation>%1: 얼굴을 찾지 못했습니다. 보통 모양의 얼굴을 추가하여 자리를 맞출 수 있습니다.</translation>
    </message>
    <message>
        <source>Contours of %1. In hand: %2. Tab goes from point to point, the arrow keys move it.</source>
        <translation>%1 사진의 윤곽선. 선택: %2. 탭 키는 점 사이를 이동하고, 화살표 키는 점을 옮깁니다.</translation>
    </message>
</context>
<context>
    <name>tp::Narrator</name>
    <message>
        <source>Voice on.</source>
        <translation>음성이 켜졌습니다.</translation>
    </message>
    <message>
        <source>Voice off.</source>
        <translation>음성이 꺼졌습니다.</translation>
    </message>
    <message>
        <source>No speech engine was found on this computer, so nothing is spoken here. A screen reader is told instead.</source>
        <translation>이 컴퓨터에서 음성 엔진을 찾지 못해 여기에서는 말하지 않습니다. 대신 화면 낭독기에 알립니다.</translation>
    </message>
</context>
<context>
    <name>tp::OpenAlbum</name>
    <message numerus="yes">
        <source>%n more thing(s) in the album need a look.</source>
        <translation>
            <numerusform>앨범에서 확인이 필요한 것이 %n개 더 있습니다.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::PhotoRows</name>
    <message>
        <source>Not looked at yet.</source>
        <translation>아직 살펴보지 않았습니다.</translation>
    </message>
    <message>
        <source>No face found.</source>
        <translation>얼굴을 찾지 못했습니다.</translation>
    </message>
    <message>
        <source>Faces look wrong: %1 % off.</source>
        <translation>얼굴이 잘못되어 보입니다: 오차 %1 %.</translation>
    </message>
    <message>
        <source>Faces about %1 % off.</source>
        <translation>얼굴 오차 약 %1 %.</translation>
    </message>
</context>
<context>
    <name>tp::PlaceWords</name>
    <message numerus="yes">
        <source>%1. On the %2, at its %3 o&apos;clock, %n millimetre(s) from its middle.</source>
        <translation>
            <numerusform>%1. %2 위, 중심에서 %3시 방향, %n밀리미터.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Beside %1. %2 at %3 o&apos;clock, %n millimetre(s).</source>
        <translation>
            <numerusform>%1 옆. %2, %3시 방향, %n밀리미터.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1. %2 at %3 o&apos;clock, %n millimetre(s).</source>
        <translation>
            <numerusform>%1. %2, %3시 방향, %n밀리미터.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::Player</name>
    <message>
        <source>The loudspeaker is gone. The recording goes on as soon as there is one again.</source>
        <translation>스피커가 없어졌습니다. 다시 생기면 바로 녹음을 이어서 재생합니다.</translation>
    </message>
    <message>
        <source>There is no loudspeaker. The recording plays as soon as there is one.</source>
        <translation>스피커가 없습니다. 스피커가 생기면 바로 녹음을 재생합니다.</translation>
    </message>
</context>
<context>
    <name>tp::Preferences</name>
    <message>
        <source>Your settings could not be read. The usual ones are used until that is mended.</source>
        <translation>설정을 읽을 수 없습니다. 고쳐질 때까지 기본 설정을 씁니다.</translation>
    </message>
    <message>
        <source>Your settings could not be read and were set aside. The usual ones are used; you can choose anew on the settings page.</source>
        <translation>설정을 읽을 수 없어 따로 옮겨 두었습니다. 기본 설정을 쓰며, 설정 페이지에서 새로 고를 수 있습니다.</translation>
    </message>
    <message>
        <source>Your settings could not be kept: %1</source>
        <translation>설정을 저장할 수 없습니다: %1</translation>
    </message>
</context>
<context>
    <name>tp::PrintSession</name>
    <message>
        <source>Print. Choose a photograph on the page for looking after the album.</source>
        <translation>인쇄. 앨범 관리 페이지에서 사진을 고르세요.</translation>
    </message>
    <message>
        <source>Print %1. Looking for faces…</source>
        <translation>인쇄, %1. 얼굴을 찾는 중…</translation>
    </message>
    <message>
        <source>Print %1 on %2.</source>
        <translation>인쇄, %1. 종이: %2.</translation>
    </message>
    <message>
        <source>There is no sheet yet.</source>
        <translation>아직 인쇄물이 없습니다.</translation>
    </message>
    <message>
        <source>The folder %1 could not be made: %2</source>
        <translation>폴더 %1: 만들 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The sheet is stored as %1. Print it at 100 percent, unscaled.</source>
        <translation>인쇄물을 저장했습니다: %1. 크기를 바꾸지 말고 100퍼센트로 인쇄하세요.</translation>
    </message>
</context>
<context>
    <name>tp::PrintedPhoto</name>
    <message>
        <source>The face</source>
        <translation>얼굴</translation>
    </message>
    <message>
        <source>All faces</source>
        <translation>모든 얼굴</translation>
    </message>
    <message>
        <source>Face %1</source>
        <translation>%1번 얼굴</translation>
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
        <translation>레터 용지</translation>
    </message>
    <message>
        <source>A3</source>
        <translation>A3</translation>
    </message>
    <message>
        <source>Braille paper, 11 by 11.5 inches</source>
        <translation>점자 용지, 11×11.5인치</translation>
    </message>
    <message>
        <source>%1 by %2 millimetres</source>
        <translation>가로 %1, 세로 %2밀리미터</translation>
    </message>
    <message>
        <source>With its name in print.</source>
        <translation>이름을 글자로도 넣습니다.</translation>
    </message>
    <message>
        <source>Without a name in print.</source>
        <translation>이름을 글자로는 넣지 않습니다.</translation>
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
        <translation>얼굴 만져 보기</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>설정</translation>
    </message>
    <message>
        <source>Listen to photographs</source>
        <translation>사진 듣기</translation>
    </message>
    <message>
        <source>Look after the album</source>
        <translation>앨범 관리</translation>
    </message>
    <message>
        <source>Mend contours</source>
        <translation>윤곽선 고치기</translation>
    </message>
    <message>
        <source>Print a tactile sheet</source>
        <translation>촉각 인쇄물 만들기</translation>
    </message>
    <message>
        <source>Lab</source>
        <translation>실험실</translation>
    </message>
</context>
<context>
    <name>tp::Questions</name>
    <message>
        <source>Should TouchPhoto speak?</source>
        <translation>TouchPhoto가 말로 알려 드릴까요?</translation>
    </message>
    <message>
        <source>How fast should it speak?</source>
        <translation>얼마나 빠르게 말할까요?</translation>
    </message>
    <message>
        <source>Who uses this tablet most?</source>
        <translation>이 태블릿을 주로 누가 쓰나요?</translation>
    </message>
    <message>
        <source>Looking for a force device.</source>
        <translation>힘 장치를 찾는 중입니다.</translation>
    </message>
    <message>
        <source>No force device was found. A finger on the screen is guided by sound instead.</source>
        <translation>힘 장치를 찾지 못했습니다. 대신 화면 위의 손가락을 소리로 이끕니다.</translation>
    </message>
    <message>
        <source>A force device was found: %1.</source>
        <translation>힘 장치를 찾았습니다: %1.</translation>
    </message>
    <message>
        <source>Where are your photographs?</source>
        <translation>사진은 어디에 있나요?</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>예</translation>
    </message>
    <message>
        <source>No, the words on the screen are enough</source>
        <translation>아니요, 화면의 글자로 충분합니다</translation>
    </message>
    <message>
        <source>No, my screen reader speaks</source>
        <translation>아니요, 제 화면 낭독기로 듣겠습니다</translation>
    </message>
    <message>
        <source>Very slowly</source>
        <translation>아주 느리게</translation>
    </message>
    <message>
        <source>Slowly</source>
        <translation>느리게</translation>
    </message>
    <message>
        <source>At the usual speed</source>
        <translation>보통 속도로</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>빠르게</translation>
    </message>
    <message>
        <source>Very fast</source>
        <translation>아주 빠르게</translation>
    </message>
    <message>
        <source>Somebody who listens and feels</source>
        <translation>듣고 만지는 사람</translation>
    </message>
    <message>
        <source>Somebody who looks after the album</source>
        <translation>앨범을 관리하는 사람</translation>
    </message>
    <message>
        <source>Go on without a device</source>
        <translation>장치 없이 계속하기</translation>
    </message>
    <message>
        <source>Use it</source>
        <translation>이 장치 쓰기</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>다시 찾기</translation>
    </message>
    <message>
        <source>In the folder %1</source>
        <translation>이 폴더: %1</translation>
    </message>
    <message>
        <source>In another folder</source>
        <translation>다른 폴더</translation>
    </message>
    <message>
        <source>Ask me later</source>
        <translation>나중에 정하기</translation>
    </message>
    <message>
        <source>Question %1 of %2. %3</source>
        <translation>질문 %2개 중 %1번째. %3</translation>
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
        <translation>지금까지 녹음한 것은 남아 있고, 마이크가 생기면 바로 이어집니다.</translation>
    </message>
    <message>
        <source>The recording begins as soon as there is one.</source>
        <translation>마이크가 생기면 바로 녹음을 시작합니다.</translation>
    </message>
    <message>
        <source>The microphone delivers no sound.</source>
        <translation>마이크에서 소리가 들어오지 않습니다.</translation>
    </message>
    <message>
        <source>This microphone cannot record 48000 samples a second; another one is needed.</source>
        <translation>이 마이크는 초당 48000개의 샘플을 녹음할 수 없습니다. 다른 마이크가 필요합니다.</translation>
    </message>
    <message>
        <source>The microphone is gone.</source>
        <translation>마이크가 없어졌습니다.</translation>
    </message>
    <message>
        <source>There is no microphone.</source>
        <translation>마이크가 없습니다.</translation>
    </message>
    <message>
        <source>There is not enough room on the disk for a recording.</source>
        <translation>디스크에 녹음할 자리가 모자랍니다.</translation>
    </message>
    <message>
        <source>The recording cannot be made: %1</source>
        <translation>녹음할 수 없습니다. %1</translation>
    </message>
    <message>
        <source>The microphone is there again. The recording goes on.</source>
        <translation>마이크가 다시 생겼습니다. 녹음을 이어 갑니다.</translation>
    </message>
    <message>
        <source>The recording begins.</source>
        <translation>녹음을 시작합니다.</translation>
    </message>
    <message>
        <source>The recording has ended, because %1</source>
        <translation>녹음이 끝났습니다. %1</translation>
    </message>
    <message>
        <source>The microphone hears nothing. It may be switched off or covered.</source>
        <translation>마이크에 아무것도 들리지 않습니다. 꺼져 있거나 가려져 있을 수 있습니다.</translation>
    </message>
    <message>
        <source>The disk is almost full, so the recording has ended.</source>
        <translation>디스크가 거의 차서 녹음이 끝났습니다.</translation>
    </message>
    <message>
        <source>A recording lasts %1 at most, so it has ended.</source>
        <translation>녹음은 최대 %1까지라서 끝났습니다.</translation>
    </message>
    <message>
        <source>The disk is almost full: %1 can still be recorded.</source>
        <translation>디스크가 거의 찼습니다. %1 더 녹음할 수 있습니다.</translation>
    </message>
    <message>
        <source>%1 can still be recorded.</source>
        <translation>%1 더 녹음할 수 있습니다.</translation>
    </message>
    <message>
        <source>What was recorded is kept as &quot;%1&quot; and will be stored later, because %2</source>
        <translation>녹음한 것은 “%1”(으)로 남겨 두었고 나중에 저장합니다. %2</translation>
    </message>
    <message>
        <source>Nothing was recorded.</source>
        <translation>녹음된 것이 없습니다.</translation>
    </message>
    <message>
        <source>Recorded: %1.</source>
        <translation>녹음됨: %1.</translation>
    </message>
</context>
<context>
    <name>tp::RecordingList</name>
    <message>
        <source>Not said</source>
        <translation>지정 안 함</translation>
    </message>
    <message>
        <source>%1, %2, %3 of %4</source>
        <translation>%1, %2, %4개 중 %3번째</translation>
    </message>
    <message>
        <source>It is the first one.</source>
        <translation>첫 번째 녹음입니다.</translation>
    </message>
    <message>
        <source>It is the last one.</source>
        <translation>마지막 녹음입니다.</translation>
    </message>
    <message>
        <source>%1 is number %2 of %3 now.</source>
        <translation>%1: 이제 %3개 중 %2번째입니다.</translation>
    </message>
    <message>
        <source>Deleted: %1. Undo brings it back.</source>
        <translation>삭제했습니다: %1. 되돌리기로 되살릴 수 있습니다.</translation>
    </message>
    <message>
        <source>Saved: %1.</source>
        <translation>저장했습니다: %1.</translation>
    </message>
    <message>
        <source>Only a sound that is a file on this computer can be added.</source>
        <translation>이 컴퓨터에 파일로 있는 소리만 추가할 수 있습니다.</translation>
    </message>
    <message>
        <source>Added: %1, %2. %3</source>
        <translation>추가했습니다: %1, %2. %3</translation>
    </message>
</context>
<context>
    <name>tp::SettingSteps</name>
    <message>
        <source>the reset</source>
        <translation>처음 상태로 돌리기</translation>
    </message>
    <message>
        <source>All settings are as they were at first. The album&apos;s folders stay.</source>
        <translation>모든 설정이 처음 상태로 돌아갔습니다. 앨범의 폴더는 그대로입니다.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>되돌릴 것이 없습니다.</translation>
    </message>
    <message>
        <source>Undone: %1.</source>
        <translation>되돌렸습니다: %1.</translation>
    </message>
</context>
<context>
    <name>tp::SettingsSession</name>
    <message>
        <source>Settings. Go through them by Tab; each change is kept at once. Control Z undoes the last one.</source>
        <translation>설정. 탭 키로 설정 사이를 이동하세요. 변경은 바로 저장됩니다. Ctrl Z는 마지막 변경을 되돌립니다.</translation>
    </message>
</context>
<context>
    <name>tp::Shell</name>
    <message>
        <source>Everywhere: Escape stops what sounds or moves, and then leads home. F1: this help. F2: the last sentence again. F3: voice on or off. Alt and Left: the previous page.</source>
        <translation>어디서나: Escape 키는 소리나 움직임을 멈추고, 그다음에는 홈으로 갑니다. F1: 이 도움말. F2: 마지막 문장 다시. F3: 음성 켜기 또는 끄기. Alt와 왼쪽 화살표 키: 이전 페이지.</translation>
    </message>
</context>
<context>
    <name>tp::SpeechSettings</name>
    <message>
        <source>TouchPhoto speaks</source>
        <translation>TouchPhoto가 말합니다</translation>
    </message>
    <message>
        <source>My screen reader speaks</source>
        <translation>화면 낭독기가 말합니다</translation>
    </message>
    <message>
        <source>Nobody speaks</source>
        <translation>말하지 않습니다</translation>
    </message>
    <message>
        <source>Very slow</source>
        <translation>아주 느리게</translation>
    </message>
    <message>
        <source>Slow</source>
        <translation>느리게</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>보통</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>빠르게</translation>
    </message>
    <message>
        <source>Very fast</source>
        <translation>아주 빠르게</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>시스템과 같게</translation>
    </message>
    <message>
        <source>who speaks</source>
        <translation>음성 안내</translation>
    </message>
    <message>
        <source>the speed of speech</source>
        <translation>말하는 속도</translation>
    </message>
    <message>
        <source>%1. This is how fast I speak.</source>
        <translation>%1. 이 속도로 말합니다.</translation>
    </message>
    <message>
        <source>the language</source>
        <translation>언어</translation>
    </message>
    <message>
        <source>the speed of recordings</source>
        <translation>녹음 재생 속도</translation>
    </message>
    <message>
        <source>Recordings play at %1 times their speed.</source>
        <translation>녹음을 %1배 속도로 재생합니다.</translation>
    </message>
    <message>
        <source>sounds</source>
        <translation>소리</translation>
    </message>
    <message>
        <source>Sounds on.</source>
        <translation>소리가 켜졌습니다.</translation>
    </message>
    <message>
        <source>Sounds off.</source>
        <translation>소리가 꺼졌습니다.</translation>
    </message>
</context>
<context>
    <name>tp::StartSession</name>
    <message>
        <source>Listen to photographs</source>
        <translation>사진 듣기</translation>
    </message>
    <message>
        <source>One photograph after the other, with what was recorded for it</source>
        <translation>사진을 하나씩, 함께 남긴 녹음과 듣습니다</translation>
    </message>
    <message>
        <source>Feel a face</source>
        <translation>얼굴 만져 보기</translation>
    </message>
    <message>
        <source>Your last photograph, under your finger</source>
        <translation>마지막으로 본 사진을 손가락으로 만집니다</translation>
    </message>
    <message>
        <source>Look after the album</source>
        <translation>앨범 관리</translation>
    </message>
    <message>
        <source>Import photographs, name people, record</source>
        <translation>사진 가져오기, 사람 이름 붙이기, 녹음하기</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>설정</translation>
    </message>
    <message>
        <source>Speech, colours, force, where photographs are</source>
        <translation>말, 색, 힘, 사진이 있는 곳</translation>
    </message>
    <message>
        <source>Take a photograph</source>
        <translation>사진 찍기</translation>
    </message>
    <message>
        <source>Not available yet: photographs of any camera can be imported</source>
        <translation>아직 없습니다. 어떤 카메라의 사진이든 가져올 수 있습니다</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>연구</translation>
    </message>
    <message>
        <source>Not available yet</source>
        <translation>아직 없습니다</translation>
    </message>
    <message>
        <source>TouchPhoto, start page. 1: %1. 2: %2. More below; F1 for help.</source>
        <translation>TouchPhoto, 시작 페이지. 1: %1. 2: %2. 아래에 더 있습니다. 도움말은 F1 키입니다.</translation>
    </message>
    <message>
        <source>Lab</source>
        <translation>실험실</translation>
    </message>
    <message>
        <source>For researchers: guidance laws, their parameters, plots, recordings</source>
        <translation>연구자용: 유도 법칙, 매개변수, 그래프, 기록</translation>
    </message>
</context>
<context>
    <name>tp::StorageSettings</name>
    <message>
        <source>No folder was chosen.</source>
        <translation>폴더를 고르지 않았습니다.</translation>
    </message>
    <message>
        <source>The album has this folder already.</source>
        <translation>이미 앨범에 있는 폴더입니다.</translation>
    </message>
    <message>
        <source>the album&apos;s new folder</source>
        <translation>앨범의 새 폴더</translation>
    </message>
    <message>
        <source>%1 belongs to the album now.</source>
        <translation>이제 앨범에 속합니다: %1.</translation>
    </message>
    <message>
        <source>the folder that left the album</source>
        <translation>앨범에서 뺀 폴더</translation>
    </message>
    <message>
        <source>%1 no longer belongs to the album. Its photographs and recordings stay where they are.</source>
        <translation>이제 앨범에 속하지 않습니다: %1. 그 사진과 녹음은 그 자리에 그대로 남습니다.</translation>
    </message>
    <message>
        <source>Nothing leaves this computer: TouchPhoto opens no connection to any other.</source>
        <translation>아무것도 이 컴퓨터를 떠나지 않습니다. TouchPhoto는 다른 컴퓨터에 연결하지 않습니다.</translation>
    </message>
    <message>
        <source>These settings, in %1.</source>
        <translation>이 설정이 저장된 곳: %1.</translation>
    </message>
    <message>
        <source>An index of the album, in %1 (%2). It can be thrown away at any time.</source>
        <translation>앨범 색인이 저장된 곳: %1 (%2). 언제든지 버려도 됩니다.</translation>
    </message>
    <message>
        <source>Where your force device lies on the screen, in %1.</source>
        <translation>힘 장치가 화면의 어디에 놓이는지, %1에 있습니다.</translation>
    </message>
    <message>
        <source>Names, descriptions and recordings, beside the photographs in %1.</source>
        <translation>사진 옆에 저장된 이름, 설명, 녹음: %1.</translation>
    </message>
    <message>
        <source>The photograph that you were at last: %1.</source>
        <translation>마지막으로 본 사진: %1.</translation>
    </message>
    <message>
        <source>The index is thrown away when TouchPhoto ends, and made anew from the photographs at the next start.</source>
        <translation>색인은 TouchPhoto가 끝날 때 버려지고, 다음에 시작할 때 사진에서 새로 만들어집니다.</translation>
    </message>
</context>
<context>
    <name>tp::TagPlayback</name>
    <message>
        <source>Next: %1.</source>
        <translation>다음: %1.</translation>
    </message>
</context>
<context>
    <name>tp::Take</name>
    <message>
        <source>Recording</source>
        <translation>녹음 중</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>일시 정지됨</translation>
    </message>
    <message>
        <source>Being stored…</source>
        <translation>저장하는 중…</translation>
    </message>
    <message>
        <source>Waiting for the microphone…</source>
        <translation>마이크를 기다리는 중…</translation>
    </message>
    <message>
        <source>nothing heard</source>
        <translation>들리는 소리 없음</translation>
    </message>
    <message>
        <source>soft</source>
        <translation>작음</translation>
    </message>
    <message>
        <source>good</source>
        <translation>알맞음</translation>
    </message>
    <message>
        <source>too loud</source>
        <translation>너무 큼</translation>
    </message>
    <message>
        <source>The recorder is still at work. Try again in a moment.</source>
        <translation>녹음기가 아직 작업 중입니다. 잠시 후 다시 시도하세요.</translation>
    </message>
    <message>
        <source>Paused.</source>
        <translation>일시 정지했습니다.</translation>
    </message>
    <message>
        <source>Throw away what was recorded? It cannot be brought back.</source>
        <translation>녹음한 것을 버릴까요? 되살릴 수 없습니다.</translation>
    </message>
    <message>
        <source>Thrown away. Nothing was changed.</source>
        <translation>버렸습니다. 바뀐 것은 없습니다.</translation>
    </message>
    <message>
        <source>Kept. The recording is paused.</source>
        <translation>버리지 않았습니다. 녹음은 일시 정지되어 있습니다.</translation>
    </message>
    <message>
        <source>%1 It is saved.</source>
        <translation>%1 저장되었습니다.</translation>
    </message>
    <message>
        <source>The album is still being changed. Try again in a moment.</source>
        <translation>앨범을 아직 바꾸는 중입니다. 잠시 후에 다시 해 보세요.</translation>
    </message>
</context>
<context>
    <name>tp::Trimming</name>
    <message>
        <source>%1 of %2 stay.</source>
        <translation>%2 중 %1 남음.</translation>
    </message>
    <message>
        <source>All of it stays.</source>
        <translation>모두 남습니다.</translation>
    </message>
    <message>
        <source>From %1</source>
        <translation>시작: %1</translation>
    </message>
    <message>
        <source>To %1</source>
        <translation>끝: %1</translation>
    </message>
    <message>
        <source>All of it stays, so there is nothing to cut off. Move the begin or the end first.</source>
        <translation>모두 남게 되어 있어 잘라낼 것이 없습니다. 먼저 시작이나 끝을 옮기세요.</translation>
    </message>
    <message>
        <source>Trimmed: %1 stay. Undo brings the rest back.</source>
        <translation>잘랐습니다. 남은 길이: %1. 되돌리기로 나머지를 되살릴 수 있습니다.</translation>
    </message>
</context>
</TS>
