<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ko" sourcelanguage="en">
<context>
    <name>AimWords</name>
    <message>
        <source>Nobody is in view. Turn slowly to the left.</source>
        <translation>아무도 보이지 않습니다. 천천히 왼쪽으로 도세요.</translation>
    </message>
    <message>
        <source>Nobody is in view. Turn slowly to the right.</source>
        <translation>아무도 보이지 않습니다. 천천히 오른쪽으로 도세요.</translation>
    </message>
    <message>
        <source>Nobody is in view. Tilt slowly up.</source>
        <translation>아무도 보이지 않습니다. 태블릿을 천천히 위로 기울이세요.</translation>
    </message>
    <message>
        <source>Nobody is in view. Tilt slowly down.</source>
        <translation>아무도 보이지 않습니다. 태블릿을 천천히 아래로 기울이세요.</translation>
    </message>
    <message>
        <source>a little left</source>
        <translation>조금 왼쪽</translation>
    </message>
    <message>
        <source>left</source>
        <translation>왼쪽</translation>
    </message>
    <message>
        <source>far left</source>
        <translation>많이 왼쪽</translation>
    </message>
    <message>
        <source>a little right</source>
        <translation>조금 오른쪽</translation>
    </message>
    <message>
        <source>right</source>
        <translation>오른쪽</translation>
    </message>
    <message>
        <source>far right</source>
        <translation>많이 오른쪽</translation>
    </message>
    <message>
        <source>a little up</source>
        <translation>조금 위로</translation>
    </message>
    <message>
        <source>up</source>
        <translation>위로</translation>
    </message>
    <message>
        <source>far up</source>
        <translation>많이 위로</translation>
    </message>
    <message>
        <source>a little down</source>
        <translation>조금 아래로</translation>
    </message>
    <message>
        <source>down</source>
        <translation>아래로</translation>
    </message>
    <message>
        <source>far down</source>
        <translation>많이 아래로</translation>
    </message>
    <message>
        <source>a little closer</source>
        <translation>조금 가까이</translation>
    </message>
    <message>
        <source>closer</source>
        <translation>가까이</translation>
    </message>
    <message>
        <source>much closer</source>
        <translation>많이 가까이</translation>
    </message>
    <message>
        <source>a little back</source>
        <translation>조금 뒤로</translation>
    </message>
    <message>
        <source>back</source>
        <translation>뒤로</translation>
    </message>
    <message>
        <source>far back</source>
        <translation>많이 뒤로</translation>
    </message>
    <message>
        <source>a little clockwise</source>
        <translation>조금 시계 방향</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>시계 방향</translation>
    </message>
    <message>
        <source>far clockwise</source>
        <translation>많이 시계 방향</translation>
    </message>
    <message>
        <source>a little anticlockwise</source>
        <translation>조금 반시계 방향</translation>
    </message>
    <message>
        <source>anticlockwise</source>
        <translation>반시계 방향</translation>
    </message>
    <message>
        <source>far anticlockwise</source>
        <translation>많이 반시계 방향</translation>
    </message>
    <message>
        <source>Too dark. More light on the face.</source>
        <translation>너무 어둡습니다. 얼굴에 빛이 더 필요합니다.</translation>
    </message>
    <message>
        <source>The light is behind them.</source>
        <translation>빛이 뒤에서 비칩니다.</translation>
    </message>
    <message>
        <source>Keep still.</source>
        <translation>움직이지 마세요.</translation>
    </message>
    <message>
        <source>Eyes are shut.</source>
        <translation>눈을 감았습니다.</translation>
    </message>
    <message>
        <source>Good. Hold still.</source>
        <translation>좋습니다. 그대로 계세요.</translation>
    </message>
    <message>
        <source>Move the tablet: %1.</source>
        <translation>태블릿을 움직이세요: %1.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>All is well. Press Space to take another photograph.</source>
        <translation>모두 알맞습니다. 스페이스바를 누르면 사진을 한 장 더 찍습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n face(s).</source>
        <translation>
            <numerusform>얼굴 %n개.</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut off at the left edge.</source>
        <translation>왼쪽 가장자리에서 잘렸습니다.</translation>
    </message>
    <message>
        <source>Cut off at the right edge.</source>
        <translation>오른쪽 가장자리에서 잘렸습니다.</translation>
    </message>
    <message>
        <source>Cut off at the upper edge.</source>
        <translation>위쪽 가장자리에서 잘렸습니다.</translation>
    </message>
    <message>
        <source>Cut off at the lower edge.</source>
        <translation>아래쪽 가장자리에서 잘렸습니다.</translation>
    </message>
    <message>
        <source>One face in the middle</source>
        <translation>한 얼굴을 가운데에</translation>
    </message>
    <message>
        <source>One face by thirds</source>
        <translation>한 얼굴을 삼등분선에</translation>
    </message>
    <message>
        <source>Head and shoulders</source>
        <translation>머리와 어깨</translation>
    </message>
    <message>
        <source>Everybody in view</source>
        <translation>모두 들어오게</translation>
    </message>
    <message numerus="yes">
        <source>%n more face(s)</source>
        <comment>at the end of a list of names</comment>
        <translation>
            <numerusform>다른 얼굴 %n개</numerusform>
        </translation>
    </message>
</context>
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
        <source>On the detail of a recording: only that one. Key: Enter</source>
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
        <source>A random photograph. Key: R</source>
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
        <translation>현재 위치</translation>
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
        <source>Cancel the calibration</source>
        <translation>보정 취소</translation>
    </message>
    <message>
        <source>Nothing is changed. Key: Escape</source>
        <translation>아무것도 바뀌지 않습니다. Escape 키</translation>
    </message>
</context>
<context>
    <name>CapturePanel</name>
    <message>
        <source>What to do</source>
        <translation>할 일</translation>
    </message>
    <message>
        <source>Import photographs</source>
        <translation>사진 가져오기</translation>
    </message>
    <message>
        <source>Of another camera, into your album. Key: I</source>
        <translation>다른 카메라의 사진을 앨범으로 가져옵니다. I 키</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>다시 시도</translation>
    </message>
    <message>
        <source>Key: R</source>
        <translation>R 키</translation>
    </message>
    <message>
        <source>What is in view?</source>
        <translation>무엇이 보이나요?</translation>
    </message>
    <message>
        <source>Says who is in the picture and what to do. Key: W</source>
        <translation>누가 보이고 무엇을 할지 말합니다. W 키</translation>
    </message>
    <message>
        <source>Aim</source>
        <translation>구도</translation>
    </message>
    <message>
        <source>Take it automatically when all is well</source>
        <translation>모두 알맞으면 자동으로 찍기</translation>
    </message>
    <message>
        <source>Back camera</source>
        <translation>후면 카메라</translation>
    </message>
    <message>
        <source>Front camera</source>
        <translation>전면 카메라</translation>
    </message>
    <message>
        <source>Key: C</source>
        <translation>C 키</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>조명</translation>
    </message>
    <message>
        <source>This camera is simulated. Arrow keys turn it, Page up and Page down move it closer and back, Shift with left and right tilts it.</source>
        <translation>이 카메라는 모의 카메라입니다. 화살표 키로 돌리고, Page Up과 Page Down으로 가까이와 뒤로 움직이며, Shift와 왼쪽이나 오른쪽 화살표 키로 기울입니다.</translation>
    </message>
    <message>
        <source>Last photograph</source>
        <translation>마지막 사진</translation>
    </message>
    <message>
        <source>Take the photograph</source>
        <translation>사진 찍기</translation>
    </message>
    <message>
        <source>Also by a touch on the camera view. Key: Space</source>
        <translation>카메라 화면을 탭해도 됩니다. 스페이스바</translation>
    </message>
    <message>
        <source>Finish the memo</source>
        <translation>메모 녹음 끝내기</translation>
    </message>
    <message>
        <source>Record a memo</source>
        <translation>메모 녹음</translation>
    </message>
    <message>
        <source>For the photograph that was taken last. Key: M</source>
        <translation>마지막으로 찍은 사진의 메모입니다. M 키</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>되돌리기</translation>
    </message>
    <message>
        <source>Deletes the photograph again. Key: Control+Z</source>
        <translation>찍은 사진을 다시 삭제합니다. Ctrl+Z 키</translation>
    </message>
    <message>
        <source>Next frame of the burst</source>
        <translation>연속 촬영의 다음 장면</translation>
    </message>
    <message>
        <source>Steps through the frames before and after it. Key: N; back: P</source>
        <translation>찍기 전과 찍은 뒤의 장면을 차례로 봅니다. N 키, 뒤로는 P 키</translation>
    </message>
    <message>
        <source>Keep this one too</source>
        <translation>이것도 저장</translation>
    </message>
    <message>
        <source>Key: K</source>
        <translation>K 키</translation>
    </message>
    <message>
        <source>Space, or a touch on the camera view: take the photograph. Then M: record a memo, and M again to finish it. N, P: look through the other frames; K: keep one. Control+Z: undo.</source>
        <translation>스페이스바나 카메라 화면 탭: 사진 찍기. 그다음 M: 메모 녹음, 다시 M: 녹음 끝내기. N, P: 다른 장면 보기, K: 저장. Ctrl+Z: 되돌리기.</translation>
    </message>
    <message>
        <source>Keep the sound of the moment</source>
        <translation>그 순간의 소리도 저장</translation>
    </message>
    <message>
        <source>The microphone is on.</source>
        <translation>마이크가 켜져 있습니다.</translation>
    </message>
    <message>
        <source>1 to 4: aim at one face in the middle, one by thirds, head and shoulders, everybody. W: what is seen. S: take it automatically or not. A: with the sound of the moment or without. C: other camera. L: light. Escape: silence.</source>
        <translation>1부터 4까지, 구도: 한 얼굴을 가운데에, 한 얼굴을 삼등분선에, 머리와 어깨, 모두. W: 보이는 것. S: 자동으로 찍기 켜기와 끄기. A: 순간의 소리와 함께 또는 소리 없이. C: 다른 카메라. L: 조명. Escape 키: 조용히.</translation>
    </message>
    <message>
        <source>Point the camera at somebody and do what is said. A tone says where to move the camera: faster is nearer, high is up, and it comes from the side to move to. It rises when all is well. Where ticks are chosen as the guide, they are felt too: faster and stronger is nearer.</source>
        <translation>카메라를 사람에게 향하고 들리는 대로 하세요. 소리가 카메라를 움직일 방향을 알려 줍니다. 빠를수록 가깝고, 높으면 위쪽이며, 움직일 쪽에서 들립니다. 모두 알맞으면 소리가 점점 높아집니다. 안내로 톡톡을 골랐다면 손으로도 느껴집니다. 빠르고 셀수록 가깝습니다.</translation>
    </message>
</context>
<context>
    <name>CaptureSurface</name>
    <message>
        <source>Camera view</source>
        <translation>카메라 화면</translation>
    </message>
    <message>
        <source>The camera is starting.</source>
        <translation>카메라를 켜는 중입니다.</translation>
    </message>
</context>
<context>
    <name>CarePage</name>
    <message>
        <source>Tab moves from control to control, the arrow keys from photograph to photograph, Enter opens one. Control+Z undoes the last step, Control+Shift+Z redoes it. Escape stops playback; it also ends a recording and keeps it.</source>
        <translation>탭 키로 항목 사이를, 화살표 키로 사진 사이를 이동하고, 엔터 키로 사진을 엽니다. Ctrl+Z는 마지막 작업을 되돌리고, Ctrl+Shift+Z는 다시 실행합니다. Escape 키는 재생을 멈추고, 녹음 중이면 녹음을 끝내고 보관합니다.</translation>
    </message>
    <message>
        <source>Each row is a person. Tab moves from control to control, the arrow keys from row to row, Enter opens one. Type who it is, or press Y where a name is offered. On a face, Delete says that it is somebody else&apos;s. Control+Z undoes the last step. Escape leads back.</source>
        <translation>한 줄이 한 사람입니다. 탭 키로 항목 사이를, 화살표 키로 줄 사이를 이동하고, 엔터 키로 엽니다. 누구인지 입력하거나, 이름이 제안되면 Y 키를 누르세요. 얼굴에서 Delete 키를 누르면 다른 사람의 얼굴로 표시됩니다. Ctrl+Z는 마지막 작업을 되돌립니다. Escape 키를 누르면 돌아갑니다.</translation>
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
        <source>Background sounds</source>
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
        <source>There is no photograph in what you chose.</source>
        <translation>선택한 것 가운데 사진이 없습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s) imported</source>
        <translation>
            <numerusform>사진 %n장 가져옴</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of them already in the album</source>
        <translation>
            <numerusform>이미 앨범에 있는 사진 %n장</numerusform>
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
        <source>%1 The import was stopped; you can continue it later.</source>
        <translation>%1 가져오기가 중단되었습니다. 나중에 이어서 할 수 있습니다.</translation>
    </message>
    <message>
        <source>Who is this?</source>
        <translation>누구인가요?</translation>
    </message>
    <message>
        <source>Who is this? Perhaps %1.</source>
        <translation>누구인가요? 아마 %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s)</source>
        <translation>
            <numerusform>사진 %n장</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message numerus="yes">
        <source>%n to confirm</source>
        <translation>
            <numerusform>확인할 것 %n개</numerusform>
        </translation>
    </message>
    <message>
        <source>Nobody was seen on two photographs yet.</source>
        <translation>아직 두 장 이상의 사진에 나온 사람이 없습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n person(s) without a name.</source>
        <translation>
            <numerusform>이름 없는 사람 %n명.</numerusform>
        </translation>
    </message>
    <message>
        <source>Everybody here has a name.</source>
        <translation>여기 있는 사람은 모두 이름이 있습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s) still to be looked at.</source>
        <translation>
            <numerusform>아직 살펴볼 사진 %n장.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n face(s) on one photograph only.</source>
        <translation>
            <numerusform>사진 한 장에만 나온 얼굴 %n개.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n face(s) too small, blurred, turned or covered to be compared.</source>
        <translation>
            <numerusform>너무 작거나 흐리거나 돌아서 있거나 가려져 비교할 수 없는 얼굴 %n개.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, to confirm</source>
        <translation>%1, 확인 필요</translation>
    </message>
    <message numerus="yes">
        <source>%n face(s) to confirm.</source>
        <translation>
            <numerusform>확인할 얼굴 %n개.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of these with something new</source>
        <translation>
            <numerusform>그중 %n장에는 새로운 것이 있음</numerusform>
        </translation>
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
        <source>%1 characters; a screen reader reads up to 250 at once.</source>
        <translation>%1자입니다. 화면 낭독기는 한 번에 250자까지 읽습니다.</translation>
    </message>
    <message>
        <source>%1 of 250 characters</source>
        <translation>250자 중 %1자</translation>
    </message>
    <message>
        <source>In more detail (%1)</source>
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
        <source>It is also saved when you leave a field.</source>
        <translation>입력란을 벗어날 때에도 저장됩니다.</translation>
    </message>
    <message>
        <source>Suggested: %1</source>
        <translation>제안: %1</translation>
    </message>
    <message>
        <source>Use the suggestion</source>
        <translation>제안 사용</translation>
    </message>
    <message>
        <source>It becomes the description in one sentence, which you can change.</source>
        <translation>한 문장 설명이 되며, 고칠 수 있습니다.</translation>
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
    <name>ExperimentDialog</name>
    <message>
        <source>Open an experiment</source>
        <translation>실험 열기</translation>
    </message>
    <message>
        <source>Experiments (%1)</source>
        <translation>실험 (%1)</translation>
    </message>
    <message>
        <source>All files (%1)</source>
        <translation>모든 파일 (%1)</translation>
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
        <source>Fits this face into the touch surface</source>
        <translation>이 얼굴을 터치 영역에 맞춥니다</translation>
    </message>
    <message>
        <source>Puts the finger there</source>
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
        <source>Press to name this face</source>
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
        <source>Language of the name</source>
        <translation>이름을 읽는 언어</translation>
    </message>
    <message>
        <source>Same as the page</source>
        <translation>페이지와 같게</translation>
    </message>
    <message>
        <source>Yes, %1</source>
        <translation>예, %1</translation>
    </message>
    <message>
        <source>Key: Y</source>
        <translation>Y 키</translation>
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
        <translation>이 폴더 선택</translation>
    </message>
    <message>
        <source>Up one folder</source>
        <translation>상위 폴더로</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
</context>
<context>
    <name>GroupListPane</name>
    <message>
        <source>Back to the photographs</source>
        <translation>사진으로 돌아가기</translation>
    </message>
    <message>
        <source>People</source>
        <translation>사람</translation>
    </message>
</context>
<context>
    <name>GroupPane</name>
    <message>
        <source>Back to the people</source>
        <translation>사람 목록으로 돌아가기</translation>
    </message>
    <message>
        <source>Yes, this is %1</source>
        <translation>예, 이 사람은 %1</translation>
    </message>
    <message>
        <source>Names all of these faces. Key: Y</source>
        <translation>이 얼굴 모두에 이름을 붙입니다. Y 키</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>얼굴</translation>
    </message>
    <message>
        <source>Not this person</source>
        <translation>이 사람이 아님</translation>
    </message>
    <message>
        <source>For the face that was chosen below. Key: Delete</source>
        <translation>아래에서 선택한 얼굴에 적용됩니다. Delete 키</translation>
    </message>
    <message>
        <source>Open the photograph</source>
        <translation>사진 열기</translation>
    </message>
    <message>
        <source>Choose somebody to say who it is.</source>
        <translation>누구인지 말할 사람을 선택하세요.</translation>
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
        <source>Import into</source>
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
        <source>Discard the unfinished import</source>
        <translation>끝나지 않은 가져오기 그만두기</translation>
    </message>
    <message>
        <source>What was imported stays.</source>
        <translation>이미 가져온 사진은 남습니다.</translation>
    </message>
</context>
<context>
    <name>JoystickMeasuring</name>
    <message>
        <source>The stick will move by itself, a little to the right and back, then a little away from you and back. Let it stand free, and keep your hands off it.</source>
        <translation>스틱이 저절로 조금 오른쪽으로 갔다가 돌아오고, 이어서 조금 앞쪽으로 갔다가 돌아옵니다. 자유롭게 세워 두고 손을 떼세요.</translation>
    </message>
    <message>
        <source>Now it is clear which way the stick pulls. Hold its grip with a kitchen scale or a luggage scale, straight towards you: the stick pulls away from you. When the grip stands still, enter how many grams the scale shows.</source>
        <translation>이제 스틱이 어느 쪽으로 당기는지 알았습니다. 주방 저울이나 여행 가방 저울로 손잡이를 곧게 자기 쪽으로 잡으세요. 스틱은 앞쪽으로 당깁니다. 손잡이가 멈추면 저울이 보여 주는 그램 수를 입력하세요.</translation>
    </message>
    <message>
        <source>The stick is measured.</source>
        <translation>스틱을 측정했습니다.</translation>
    </message>
    <message>
        <source>The stick did not stand still. Let go of it, check that nothing touches it, and measure again.</source>
        <translation>스틱이 가만히 있지 않았습니다. 손을 떼고 아무것도 닿지 않는지 확인하고 다시 측정하세요.</translation>
    </message>
    <message>
        <source>The stick did not move. Check that its power supply is plugged in, keep your hands off it, and measure again.</source>
        <translation>스틱이 움직이지 않았습니다. 전원 어댑터가 꽂혀 있는지 확인하고 손을 뗀 채 다시 측정하세요.</translation>
    </message>
    <message>
        <source>The stick moved to one side of where it should have gone. It cannot be measured like that: check that nothing touches it and that it stands straight, and measure again.</source>
        <translation>스틱이 가야 할 쪽에서 벗어나 움직였습니다. 그렇게는 측정할 수 없습니다. 아무것도 닿지 않고 곧게 서 있는지 확인하고 다시 측정하세요.</translation>
    </message>
    <message>
        <source>The stick did not come back the way it went. Check that nothing touches it, and measure again.</source>
        <translation>스틱이 간 대로 돌아오지 않았습니다. 아무것도 닿지 않는지 확인하고 다시 측정하세요.</translation>
    </message>
    <message>
        <source>The stick was not weighed for three minutes, and its force is off. Measure it again when a scale is at hand.</source>
        <translation>3분 동안 무게를 재지 않아 스틱의 힘을 껐습니다. 저울이 준비되면 다시 측정하세요.</translation>
    </message>
</context>
<context>
    <name>KeyHelp</name>
    <message>
        <source>Arrow keys, with Shift faster: move the hand. Tab: next feature. W: where am I. Z, Shift+Z: zoom in and out. Space: tour of the feature. T: tour of the face. G: guide. F: next face. N, Shift+N: next and previous photograph with a face. Enter: force on. Escape: stop. V: voice. O: open.</source>
        <translation>화살표 키: 손 이동, Shift와 함께 누르면 더 빠르게. 탭 키: 다음 부위. W: 현재 위치. Z, Shift+Z: 확대와 축소. 스페이스바: 부위 안내. T: 얼굴 안내. G: 길잡이. F: 다음 얼굴. N, Shift+N: 얼굴이 있는 다음 사진과 이전 사진. 엔터 키: 힘 켜기. Escape 키: 멈춤. V: 음성. O: 열기.</translation>
    </message>
    <message>
        <source>Touch: one finger explores. Double tap: where am I. Double tap and hold: zoom to what is there, or out. Two-finger tap: stop. Two-finger double tap: tour. Three-finger tap: where am I. Two-finger swipe to the right or left: next or previous photograph with a face.</source>
        <translation>터치: 한 손가락으로 살펴보기. 두 번 탭하기: 현재 위치. 두 번 탭하고 누르고 있기: 그곳을 확대하거나 축소. 두 손가락으로 탭하기: 멈춤. 두 손가락으로 두 번 탭하기: 안내. 세 손가락으로 탭하기: 현재 위치. 두 손가락으로 오른쪽이나 왼쪽으로 쓸어 넘기기: 얼굴이 있는 다음 사진이나 이전 사진.</translation>
    </message>
    <message>
        <source>In the picture: ring, the hand; disc, the finger; arrow, the pull of the line; small disc, where ticks lead.</source>
        <translation>화면에서: 고리는 손, 원판은 손가락, 화살표는 선이 당기는 힘, 작은 원판은 톡톡이 이끄는 곳입니다.</translation>
    </message>
</context>
<context>
    <name>LabControls</name>
    <message>
        <source>What is felt</source>
        <translation>촉감</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>장면</translation>
    </message>
    <message>
        <source>Open photograph…</source>
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
        <source>Missing readings</source>
        <translation>누락되는 측정값</translation>
    </message>
    <message>
        <source>No readings at all</source>
        <translation>측정값 전혀 없음</translation>
    </message>
    <message>
        <source>Accepts no force</source>
        <translation>힘을 받지 않음</translation>
    </message>
    <message>
        <source>Motors switch themselves off</source>
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
        <source>Key: Control+Z</source>
        <translation>Ctrl+Z 키</translation>
    </message>
    <message>
        <source>Reset all parameters</source>
        <translation>모든 매개변수 초기화</translation>
    </message>
    <message>
        <source>Can be undone</source>
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
        <source>Save the plots as a table</source>
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
        <source>Set the strongest force of real devices</source>
        <translation>실제 장치의 최대 힘 정하기</translation>
    </message>
    <message>
        <source>Opens the settings</source>
        <translation>설정을 엽니다</translation>
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
        <source>Stop recording</source>
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
        <translation>손가락 위치</translation>
    </message>
    <message>
        <source>Key: W</source>
        <translation>W 키</translation>
    </message>
    <message>
        <source>Read out the plots</source>
        <translation>그래프 읽기</translation>
    </message>
    <message>
        <source>Key: P</source>
        <translation>P 키</translation>
    </message>
    <message>
        <source>On the surface, arrow keys move the hand and Space starts and stops the servo. R records, W says where the finger is, P reads out the plots, O opens a photograph, Control+Z undoes a change. Escape stops whatever is running.</source>
        <translation>터치 영역에서 화살표 키는 손을 움직이고 스페이스바는 서보를 켜고 끕니다. R은 기록, W는 손가락의 위치, P는 그래프 읽기, O는 사진 열기이며, Ctrl+Z는 변경을 되돌립니다. Escape 키는 실행 중인 것을 멈춥니다.</translation>
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
        <source>Who it is about</source>
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
        <source>Speaker not given</source>
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
        <translation>힘 스틱 측정</translation>
    </message>
    <message>
        <source>Grams on the scale</source>
        <translation>저울의 그램 수</translation>
    </message>
    <message>
        <source>Type, or use the slider below</source>
        <translation>입력하거나 아래 슬라이더를 움직이세요</translation>
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
        <source>Use this weight</source>
        <translation>이 무게 사용</translation>
    </message>
    <message>
        <source>Cancel the measurement</source>
        <translation>측정 취소</translation>
    </message>
    <message>
        <source>Nothing is changed. Key: Escape</source>
        <translation>아무것도 바뀌지 않습니다. Escape 키</translation>
    </message>
</context>
<context>
    <name>MendPage</name>
    <message>
        <source>Tab goes from point to point of the photograph&apos;s lines, Page Up and Page Down from feature to feature. Arrow keys move a point by one pixel, with Shift by ten, with Control by a fifth. A adds a point, Delete deletes it, C turns a corner into a smooth point. Control+Z undoes the last step, Control+S saves; leaving the page saves too.</source>
        <translation>탭 키는 사진 위 선의 점에서 점으로, Page Up과 Page Down 키는 부위에서 부위로 갑니다. 화살표 키는 점을 1픽셀씩, Shift와 함께 누르면 10픽셀씩, Ctrl과 함께 누르면 5분의 1픽셀씩 옮깁니다. A는 점을 추가하고, Delete는 점을 삭제하고, C는 모서리를 매끄러운 점으로 바꿉니다. Ctrl+Z는 마지막 작업을 되돌리고, Ctrl+S는 저장합니다. 페이지를 떠날 때도 저장됩니다.</translation>
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
        <source>Selected</source>
        <translation>선택된 것</translation>
    </message>
    <message>
        <source>%1: missing</source>
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
        <source>After the selected one. Key: A. Or double-click beside a line</source>
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
        <source>Reset the feature</source>
        <translation>부위 초기화</translation>
    </message>
    <message>
        <source>Undoes the changes to this feature only</source>
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
        <source>Zoom in</source>
        <translation>확대</translation>
    </message>
    <message>
        <source>Key: Plus</source>
        <translation>더하기 키</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>축소</translation>
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
        <source>Shows what is felt</source>
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
        <source>One of the usual shape, for you to move into place</source>
        <translation>보통 모양의 얼굴이며, 자리를 맞춰야 합니다</translation>
    </message>
    <message>
        <source>Discard all changes</source>
        <translation>모든 변경 버리기</translation>
    </message>
    <message>
        <source>The contours as they were when opened. Can be undone</source>
        <translation>열었을 때의 윤곽선으로 돌아갑니다. 되돌릴 수 있습니다</translation>
    </message>
    <message>
        <source>Keys on the photograph: Tab and Shift+Tab go from point to point; arrow keys move it by one pixel, with Shift by ten, with Control by a fifth; Page Up and Page Down change the feature; A adds a point, Delete deletes it, C makes it a corner or smooth, M moves the whole feature, F shows the force, plus and minus zoom, 0 shows all, Z this feature, W says where you are.</source>
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
        <source>Tab goes from point to point. Arrow keys move it by one pixel of the photograph, with Shift by ten, with Control by a fifth. Page Up and Page Down change the feature.</source>
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
        <source>A finger will not notice the difference from what the program found.</source>
        <translation>프로그램이 찾은 것과의 차이를 손가락으로는 느낄 수 없습니다.</translation>
    </message>
    <message>
        <source>A finger notices the difference from what the program found on %1 % of the surface; there the force differs by up to %2 N.</source>
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
        <source>The row read out last. Key: Enter</source>
        <translation>마지막으로 읽어 준 줄을 고릅니다. 엔터 키</translation>
    </message>
    <message>
        <source>Letters to type with</source>
        <translation>글자판</translation>
    </message>
    <message>
        <source>Delete the last letter</source>
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
        <source>Checking faces, %n photograph(s) left…</source>
        <translation>
            <numerusform>얼굴을 확인하는 중, 사진 %n장 남음…</numerusform>
        </translation>
    </message>
    <message>
        <source>There are no photographs in the album yet.</source>
        <translation>앨범에 아직 사진이 없습니다.</translation>
    </message>
    <message>
        <source>The album has no folder yet. You will be asked for one when you import.</source>
        <translation>앨범에 아직 폴더가 없습니다. 사진을 가져올 때 폴더를 묻습니다.</translation>
    </message>
    <message>
        <source>People…</source>
        <translation>사람…</translation>
    </message>
    <message>
        <source>Says once who somebody is, for all photographs.</source>
        <translation>누구인지 한 번만 말하면 모든 사진에 적용됩니다.</translation>
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
        <source>Mend contours…</source>
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
        <source>With everything that belongs to it. Undo brings it back.</source>
        <translation>사진에 딸린 것도 모두 삭제합니다. 되돌리기로 되살릴 수 있습니다.</translation>
    </message>
    <message>
        <source>Choose a photograph to look after it.</source>
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
        <source>background sounds</source>
        <translation>주변 소리</translation>
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
    <message>
        <source>No recordings yet.</source>
        <translation>아직 녹음이 없습니다.</translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s).</source>
        <translation>
            <numerusform>녹음 %n개.</numerusform>
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
        <source>Choose the paper and the face, then save the sheet as PDF for a printer or as SVG for a drawing program. Swell paper and embossers raise its black lines and dots.</source>
        <translation>종이와 얼굴을 고른 다음, 프린터용 PDF나 그리기 프로그램용 SVG로 인쇄물을 저장하세요. 입체 복사지나 점자 프린터를 쓰면 검은 선과 점이 도드라집니다.</translation>
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
        <source>Turn by 90 degrees</source>
        <translation>90도 돌리기</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>누구</translation>
    </message>
    <message>
        <source>Name in print</source>
        <translation>이름을 글자로도 넣기</translation>
    </message>
    <message>
        <source>Save as PDF</source>
        <translation>PDF로 저장</translation>
    </message>
    <message>
        <source>Save as SVG</source>
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
        <source>No recordings yet.</source>
        <translation>아직 녹음이 없습니다.</translation>
    </message>
    <message>
        <source>Selected: %1</source>
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
    <name>RunView</name>
    <message>
        <source>This is tried out. Nothing is kept.</source>
        <translation>시험 실행입니다. 아무것도 저장되지 않습니다.</translation>
    </message>
    <message>
        <source>I agree</source>
        <translation>동의합니다</translation>
    </message>
    <message>
        <source>Key: Enter</source>
        <translation>엔터 키</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Start the trial</source>
        <translation>시행 시작</translation>
    </message>
    <message>
        <source>End the trial</source>
        <translation>시행 끝내기</translation>
    </message>
    <message>
        <source>End</source>
        <translation>끝내기</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>계속</translation>
    </message>
    <message>
        <source>Key: Space</source>
        <translation>스페이스바</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>일시 정지</translation>
    </message>
    <message>
        <source>The force is off at once. Key: P</source>
        <translation>힘이 바로 꺼집니다. P 키</translation>
    </message>
    <message>
        <source>I do not agree</source>
        <translation>동의하지 않습니다</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>연구 그만두기</translation>
    </message>
    <message>
        <source>Key: Escape</source>
        <translation>Escape 키</translation>
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
        <source>&quot;%1&quot; cannot be added: %2</source>
        <translation>“%1”: 추가할 수 없습니다. %2</translation>
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
        <source>&quot;%1&quot; is a link; it is left alone.</source>
        <translation>“%1”: 링크이므로 건드리지 않습니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a file.</source>
        <translation>“%1”: 파일이 아닙니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a file; it is left alone.</source>
        <translation>“%1”: 파일이 아니므로 건드리지 않습니다.</translation>
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
        <source>&quot;%1&quot; already exists, so nothing was moved.</source>
        <translation>“%1”: 이미 있어서 아무것도 옮기지 않았습니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; exists, so it stays on the list.</source>
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
        <source>%1 It was left as it is.</source>
        <translation>%1 그대로 두었습니다.</translation>
    </message>
    <message>
        <source>%1 Some photographs kept the new name: %2</source>
        <translation>%1 일부 사진에는 새 이름이 남았습니다. %2</translation>
    </message>
    <message>
        <source>%1 became %2</source>
        <translation>이름 변경: %1, 이제 %2</translation>
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
        <source>%1 is not between %2 and %3.</source>
        <translation>%1: %2에서 %3 사이가 아닙니다.</translation>
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
        <source>A motor of the force pad took too much current. Check that nothing blocks the knob.</source>
        <translation>힘 패드의 모터에 전류가 너무 많이 흘렀습니다. 손잡이를 막는 것이 없는지 살펴보세요.</translation>
    </message>
    <message>
        <source>A person needs a name before it can be recorded.</source>
        <translation>이름을 녹음하려면 먼저 사람의 이름이 있어야 합니다.</translation>
    </message>
    <message>
        <source>A person needs a name, and a different one than before.</source>
        <translation>이름이 있어야 하며, 전과 다른 이름이어야 합니다.</translation>
    </message>
    <message>
        <source>A picture and the touch surface both need a width and a height above zero.</source>
        <translation>사진과 터치 영역 모두 너비와 높이가 0보다 커야 합니다.</translation>
    </message>
    <message>
        <source>A recording is listed as %1, which is not a file name; it is left out.</source>
        <translation>녹음 목록의 %1: 파일 이름이 아니어서 뺐습니다.</translation>
    </message>
    <message>
        <source>A tactile sheet is written as .pdf or .svg, not as &quot;%1&quot;.</source>
        <translation>촉각 인쇄물은 .pdf나 .svg로 저장합니다. “%1” 형식은 쓸 수 없습니다.</translation>
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
        <source>Another program is using &quot;%1&quot;; try again.</source>
        <translation>“%1”: 다른 프로그램이 쓰고 있습니다. 다시 해 보세요.</translation>
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
        <source>Nothing was deleted, because the trash cannot be created: %1</source>
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
        <source>Pictures other than JPEG need the library %1 (Debian: %2), which is not installed: install it or save the picture as JPEG.</source>
        <translation>JPEG가 아닌 사진에는 라이브러리 %1(데비안: %2)이 필요한데 여기에 없습니다. 설치하거나 사진을 JPEG로 저장하세요.</translation>
    </message>
    <message>
        <source>Qt&apos;s driver for SQLite is not installed; without it there is no album. On Debian it is the package libqt6sql6-sqlite.</source>
        <translation>SQLite용 Qt 드라이버가 없어 앨범을 쓸 수 없습니다. 데비안에서는 libqt6sql6-sqlite 패키지입니다.</translation>
    </message>
    <message>
        <source>Stiffness and range of the guidance must both be numbers above zero.</source>
        <translation>유도의 강성과 범위는 모두 0보다 큰 숫자여야 합니다.</translation>
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
        <translation>%1: 가려진 듯하여 윤곽선이 틀릴 수 있습니다.</translation>
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
        <source>The album&apos;s index %1; it was set aside as &quot;%2&quot; and is rebuilt. The photographs are not affected.</source>
        <translation>앨범 색인이 %1. 그 색인을 치워 두고(“%2”) 새로 만듭니다. 사진은 그대로입니다.</translation>
    </message>
    <message>
        <source>The album&apos;s index cannot be kept in &quot;%1&quot;; it is held in memory and rebuilt at every start: %2</source>
        <translation>앨범 색인을 “%1”에 둘 수 없어 메모리에 두고 시작할 때마다 새로 만듭니다. %2</translation>
    </message>
    <message>
        <source>The album&apos;s index cannot be created: %1.</source>
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
        <source>The album&apos;s index is damaged; it is rebuilt when the album is next opened. The photographs are not affected.</source>
        <translation>앨범 색인이 손상되었습니다. 앨범을 다음에 열 때 새로 만듭니다. 사진은 그대로입니다.</translation>
    </message>
    <message>
        <source>The braille table %1 was not found; names cannot be written in braille. Install the package liblouis-data.</source>
        <translation>점자표(%1)를 찾지 못해 이름을 점자로 쓸 수 없습니다. liblouis-data 패키지를 설치하세요.</translation>
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
        <source>The device was switched off, because this computer stopped responding for a while. Start it again when you are ready.</source>
        <translation>컴퓨터가 한동안 응답하지 않아 장치를 껐습니다. 준비가 되면 다시 켜세요.</translation>
    </message>
    <message>
        <source>The device with a force pad&apos;s ids does not answer like a force pad. Unplug it and plug it in again; if it is not a force pad, choose another device.</source>
        <translation>힘 패드의 식별 번호를 가진 장치가 힘 패드처럼 응답하지 않습니다. 뽑았다가 다시 꽂으세요. 힘 패드가 아니면 다른 장치를 고르세요.</translation>
    </message>
    <message>
        <source>The drawing cannot be saved as &quot;%1&quot;: %2</source>
        <translation>그림 “%1”: 저장할 수 없습니다. %2</translation>
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
        <source>The file &quot;%1&quot; is named like a photograph, but is not one.</source>
        <translation>파일 “%1”: 이름은 사진 같지만 사진이 아닙니다.</translation>
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
        <source>The folder &quot;%1&quot; cannot be created: %2</source>
        <translation>폴더 “%1”: 만들 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be read: %2</source>
        <translation>폴더 “%1”: 읽을 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; is missing.</source>
        <translation>폴더 “%1”: 없습니다.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; leads to the whole computer; it is left alone.</source>
        <translation>폴더 “%1”: 컴퓨터 전체로 이어지므로 건드리지 않습니다.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be opened: you are not allowed to.</source>
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
        <source>The force pad %1 reports values that cannot be right: %2. It needs different firmware.</source>
        <translation>힘 패드 %1의 값이 올바르지 않습니다: %2. 다른 펌웨어가 필요합니다.</translation>
    </message>
    <message>
        <source>The force pad could not be homed. Check that it is plugged in, and try again.</source>
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
        <translation>힘 패드의 모터가 너무 뜨겁습니다. 식으면 자동으로 다시 움직입니다.</translation>
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
        <source>The map between two frames cannot be inverted, because it flattens the plane to a line.</source>
        <translation>두 좌표계의 변환이 평면을 선으로 눌러 거꾸로 할 수 없습니다.</translation>
    </message>
    <message>
        <source>The mended contours &quot;%1&quot; cannot be removed: %2</source>
        <translation>고친 윤곽선 “%1”: 없앨 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The mended contours cannot be saved as &quot;%1&quot;: %2</source>
        <translation>고친 윤곽선 “%1”: 저장할 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The mended contours in %1 cannot be used, so the program&apos;s own are used: %2</source>
        <translation>%1: 고친 윤곽선을 쓸 수 없어 프로그램의 윤곽선을 씁니다. %2</translation>
    </message>
    <message>
        <source>The mended contours in %1 cannot be used: %2</source>
        <translation>%1: 고친 윤곽선을 쓸 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The name cannot be saved: %1</source>
        <translation>이름을 저장할 수 없습니다. %1</translation>
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
        <source>The photograph &quot;%1&quot; holds more metadata than any program writes; it was not read.</source>
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
        <source>The photograph&apos;s own metadata is damaged; what could be read of it is used.</source>
        <translation>사진에 든 정보가 손상되었습니다. 읽을 수 있는 것만 씁니다.</translation>
    </message>
    <message>
        <source>The picture cannot be decoded.</source>
        <translation>사진을 디코딩할 수 없습니다.</translation>
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
        <translation>사진이나 터치 영역이 계산하기에 너무 크거나 작습니다.</translation>
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
        <source>The position is not a place on Earth and is left out.</source>
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
        <source>The recording &quot;%1&quot; cannot be listed: XML cannot hold such a file name.</source>
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
        <source>The recording %1 is listed twice; the first is used.</source>
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
        <translation>“%1”의 사이드카: 두 곳에서 동시에 바뀌었습니다. 이제 둘 다 들어 있고, 사본은 휴지통에 있습니다(“%2”).</translation>
    </message>
    <message>
        <source>The sound of &quot;%1&quot; is not whole. %2</source>
        <translation>“%1”의 소리가 온전하지 않습니다. %2</translation>
    </message>
    <message>
        <source>The sound of the video &quot;%1&quot; is not imported: %2</source>
        <translation>동영상 “%1”의 소리를 가져오지 못했습니다. %2</translation>
    </message>
    <message>
        <source>The sound of the video in &quot;%1&quot; is not imported: %2</source>
        <translation>“%1” 안 동영상의 소리를 가져오지 못했습니다. %2</translation>
    </message>
    <message>
        <source>The speaker %1</source>
        <translation>%1의 말하는 사람</translation>
    </message>
    <message>
        <source>The system gives this program no thread to work on; close other programs.</source>
        <translation>시스템이 이 프로그램에 작업 스레드를 주지 않습니다. 다른 프로그램을 닫으세요.</translation>
    </message>
    <message>
        <source>The system watches only a part of the album&apos;s folders; changes by other programs in the others are noticed %1 seconds later.</source>
        <translation>시스템이 앨범 폴더의 일부만 지켜봅니다. 나머지에서 다른 프로그램이 바꾼 것은 %1초 늦게 알게 됩니다.</translation>
    </message>
    <message>
        <source>The tactile sheet cannot be saved as &quot;%1&quot;: %2</source>
        <translation>촉각 인쇄물 “%1”: 저장할 수 없습니다. %2</translation>
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
        <source>There is no braille for the language &quot;%1&quot;; there is for en, de and ko.</source>
        <translation>언어 “%1”의 점자는 없습니다. en, de, ko가 있습니다.</translation>
    </message>
    <message>
        <source>There is no device &quot;%1&quot; now. Check that it is plugged in; &quot;touchphoto-lab devices&quot; lists what is there.</source>
        <translation>장치 “%1”: 지금 없습니다. 꽂혀 있는지 확인하세요. “touchphoto-lab devices”가 있는 장치를 알려 줍니다.</translation>
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
        <translation>“%2”: 녹음 “%1” 파일이 없습니다.</translation>
    </message>
    <message>
        <source>There is no such file.</source>
        <translation>그런 파일이 없습니다.</translation>
    </message>
    <message>
        <source>There is no unfinished import &quot;%1&quot;.</source>
        <translation>“%1”: 끝나지 않은 그런 가져오기가 없습니다.</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture.</source>
        <translation>이 사진을 열 메모리가 모자랍니다.</translation>
    </message>
    <message>
        <source>There is nothing of the name &quot;%1&quot; in the trash.</source>
        <translation>“%1”: 휴지통에 없습니다.</translation>
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
        <source>This is not a recording of a force device, or it is from a later version of TouchPhoto.</source>
        <translation>힘 장치의 기록이 아니거나 TouchPhoto의 더 새로운 버전에서 만든 기록입니다.</translation>
    </message>
    <message>
        <source>This is not an SVG drawing: it begins with &lt;%1&gt; where &lt;svg&gt; is expected.</source>
        <translation>SVG 그림이 아닙니다. &lt;svg&gt;로 시작해야 하는데 &lt;%1&gt; 요소로 시작합니다.</translation>
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
        <source>What another program wrote cannot be saved: %1</source>
        <translation>다른 프로그램이 쓴 것을 저장할 수 없습니다. %1</translation>
    </message>
    <message>
        <source>What other programs wrote differs in: %1. The other version is in the copy.</source>
        <translation>다른 프로그램이 쓴 것이 서로 다릅니다: %1. 다른 것은 사본에 있습니다.</translation>
    </message>
    <message>
        <source>The metadata of the photograph &quot;%1&quot; cannot be read.</source>
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
        <source>You are not allowed to use the %1 yet. Copy resources/udev/70-touchphoto.rules to /etc/udev/rules.d, then unplug the device and plug it in again.</source>
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
        <source>another program is using it.</source>
        <translation>다른 프로그램이 쓰고 있습니다.</translation>
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
        <source>it has another name too, and is not written into.</source>
        <translation>다른 이름도 있는 파일이므로 쓰지 않습니다.</translation>
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
        <translation>일반 파일이 아닌 것이 들어 있습니다: “%1”.</translation>
    </message>
    <message>
        <source>it holds &quot;%1&quot;, which would lie outside the album.</source>
        <translation>앨범 밖에 놓일 파일이 들어 있습니다: “%1”.</translation>
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
        <source>it is a link; it is left alone.</source>
        <translation>링크이므로 건드리지 않습니다.</translation>
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
        <source>it is damaged, or not a sound file that can be read here.</source>
        <translation>손상되었거나 여기서 읽을 수 없는 소리 파일입니다.</translation>
    </message>
    <message>
        <source>it is damaged, or not a video that can be read here.</source>
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
        <source>it is not a lab setup of version 1.</source>
        <translation>실험실 설정 버전 1이 아닙니다.</translation>
    </message>
    <message>
        <source>it is not a sound file that can be read here.</source>
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
        <source>it does not exist.</source>
        <translation>파일이 없습니다.</translation>
    </message>
    <message>
        <source>it is not whole XML.</source>
        <translation>온전한 XML이 아닙니다.</translation>
    </message>
    <message>
        <source>it names a law that is unknown.</source>
        <translation>알 수 없는 유도 법칙이 적혀 있습니다.</translation>
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
        <source>its strongest force is zero or above 20 newtons</source>
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
        <source>recordings do not have its sample rate.</source>
        <translation>녹음에 쓰지 않는 샘플 속도입니다.</translation>
    </message>
    <message>
        <source>its samples are not of 16 bit.</source>
        <translation>샘플이 16비트가 아닙니다.</translation>
    </message>
    <message>
        <source>its sound cannot be decoded.</source>
        <translation>소리를 디코딩할 수 없습니다.</translation>
    </message>
    <message>
        <source>its sound has %1 channels; at most %2 can be read.</source>
        <translation>소리의 채널이 %1개입니다. %2개까지 읽을 수 있습니다.</translation>
    </message>
    <message>
        <source>its sound is of a kind that cannot be decoded here (%1).</source>
        <translation>여기서 디코딩할 수 없는 종류의 소리입니다(%1).</translation>
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
        <translation>소리를 전혀 디코딩할 수 없습니다.</translation>
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
        <source>reading it needs the library %1 of FFmpeg (Debian: %2), which is not installed.</source>
        <translation>읽는 데 필요한 FFmpeg의 라이브러리 %1(데비안: %2)가 설치되어 있지 않습니다.</translation>
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
        <translation>모의 장치</translation>
    </message>
    <message>
        <source>the FLAC encoder reports a fault.</source>
        <translation>FLAC 인코더에 문제가 있습니다.</translation>
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
        <translation>“%1” 폴더가 없습니다.</translation>
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
        <source>what was written is not what should have been written; the disk or the memory may be faulty.</source>
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
        <source>A calibration sample is not a valid place; touch the marks again.</source>
        <translation>보정에 쓸 수 없는 측정값이 있습니다. 표시를 다시 누르세요.</translation>
    </message>
    <message>
        <source>The calibration could not be saved: %1</source>
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
        <translation>힘 스틱이 힘을 받아들이지 않습니다. 뽑았다가 다시 꽂으세요.</translation>
    </message>
    <message>
        <source>The force stick does not take what this computer sends. It goes on by itself when it does.</source>
        <translation>힘 스틱이 이 컴퓨터가 보내는 것을 받지 않습니다. 다시 받으면 자동으로 계속됩니다.</translation>
    </message>
    <message>
        <source>The force stick has no room for a force. Close other programs that use it, unplug it and plug it in again.</source>
        <translation>힘 스틱에 힘을 넣을 자리가 없습니다. 이 장치를 쓰는 다른 프로그램을 닫고, 뽑았다가 다시 꽂으세요.</translation>
    </message>
    <message>
        <source>The force stick has switched its motors off. Check that its power supply is plugged in and that no other program uses it.</source>
        <translation>힘 스틱이 모터를 껐습니다. 전원 어댑터가 꽂혀 있는지, 다른 프로그램이 사용하고 있지 않은지 확인하세요.</translation>
    </message>
    <message>
        <source>The force stick&apos;s safety switch keeps its motors off. Hold the grip as its maker says, or release the switch.</source>
        <translation>힘 스틱의 안전 스위치 때문에 모터가 꺼져 있습니다. 제조사가 안내한 대로 손잡이를 잡거나 스위치를 푸세요.</translation>
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
        <source>what it reports of itself makes no sense</source>
        <translation>장치가 알리는 정보가 올바르지 않습니다</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not say in what language a name is read: %2 Move it away, then choose the language again.</source>
        <translation>“%1”에서 이름을 읽는 언어를 알 수 없습니다: %2 파일을 다른 곳으로 옮긴 다음 언어를 다시 고르세요.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a language tag, such as de or pt-BR.</source>
        <translation>“%1”: de나 pt-BR 같은 언어 태그가 아닙니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; says how the name of %2 is read, but is not in its place.</source>
        <translation>“%1”: %2의 이름을 읽는 언어가 들어 있지만 제자리에 있지 않습니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; says what to import, but this computer did not note it; it is left alone. Import the photographs themselves again; nothing comes twice.</source>
        <translation>“%1”: 가져올 것을 적어 놓았지만 이 컴퓨터가 적은 것이 아니므로 건드리지 않습니다. 사진을 다시 가져오세요. 두 번 들어오는 것은 없습니다.</translation>
    </message>
    <message>
        <source>A person needs a name before its language can be chosen.</source>
        <translation>이름의 언어를 고르려면 먼저 사람의 이름이 있어야 합니다.</translation>
    </message>
    <message>
        <source>The language of the name cannot be saved: %1</source>
        <translation>이름의 언어를 저장할 수 없습니다: %1</translation>
    </message>
    <message>
        <source>its first line is not a language tag, such as de or pt-BR.</source>
        <translation>첫 줄이 de나 pt-BR 같은 언어 태그가 아닙니다.</translation>
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
        <translation>“%1”: 팰컨의 펌웨어가 아닙니다. 파일이 너무 작습니다. 올바른 파일을 그곳에 복사하세요.</translation>
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
        <source>The Falcon does not answer. Check that it is plugged in and has power, and try again.</source>
        <translation>팰컨이 응답하지 않습니다. 연결되어 있고 전원이 들어오는지 확인한 뒤 다시 시도하세요.</translation>
    </message>
    <message>
        <source>The Falcon does not answer. Check that its power supply is plugged in, unplug its USB cable, plug it in again and try once more.</source>
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
        <source>The Falcon needs its firmware, which its maker does not let this program include. Copy the firmware file of its maker&apos;s software to %1.</source>
        <translation>팰컨에는 펌웨어가 필요하지만 제조사가 이 프로그램에 넣는 것을 허락하지 않습니다. 제조사 소프트웨어의 펌웨어 파일을 이곳에 복사하세요: %1.</translation>
    </message>
    <message>
        <source>The Falcon took its firmware and does not answer. Perhaps %1 is not the firmware of a Falcon.</source>
        <translation>팰컨이 펌웨어를 받았지만 응답하지 않습니다. %1 파일이 팰컨의 펌웨어가 아닐 수 있습니다.</translation>
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
        <source>The Haply 2diy could not be homed. Check that it is plugged in and switched on, and try again.</source>
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
        <source>The device at the serial port does not answer like a Haply 2diy. Switch it on, unplug it and plug it in again; if it is not a Haply 2diy, choose another device.</source>
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
        <source>The device stays off, because the program that watches over its motors, touchphoto-force-guard, is missing. Install TouchPhoto again.</source>
        <translation>모터를 지켜보는 프로그램 touchphoto-force-guard가 없어서 장치를 켜지 않습니다. TouchPhoto를 다시 설치하세요.</translation>
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
        <source>You are not allowed to use the %1 yet. Copy resources/udev/70-touchphoto.rules to /etc/udev/rules.d, then unplug the device and plug it in again; or have yourself added to the group dialout and log in again.</source>
        <translation>아직 %1 장치를 쓸 권한이 없습니다. resources/udev/70-touchphoto.rules를 /etc/udev/rules.d에 복사한 다음 장치를 뽑았다가 다시 꽂으세요. 또는 dialout 그룹에 추가해 달라고 하고 다시 로그인하세요.</translation>
    </message>
    <message>
        <source>it holds &quot;%1&quot;, which is packed in an unusual way. Pack it again as an ordinary ZIP file.</source>
        <translation>흔하지 않은 방식으로 압축된 파일이 들어 있습니다: “%1”. 일반 ZIP 파일로 다시 압축하세요.</translation>
    </message>
    <message>
        <source>A stick cannot be as strong or as weak as that. Check that the scale shows grams and pulls straight towards you, and weigh again.</source>
        <translation>스틱이 그렇게 세거나 약할 수는 없습니다. 저울이 그램으로 표시하고 곧게 자기 쪽으로 당기는지 확인한 뒤 다시 무게를 재세요.</translation>
    </message>
    <message>
        <source>The stick does not pull now. Hold the grip where it is, and weigh again.</source>
        <translation>스틱이 지금 당기지 않습니다. 손잡이를 그 자리에 잡고 다시 무게를 재세요.</translation>
    </message>
    <message>
        <source>What the scale shows must be a number of grams from 0 to 100000.</source>
        <translation>저울이 보여 주는 것은 0에서 100000까지의 그램 수여야 합니다.</translation>
    </message>
    <message>
        <source>What was measured of the stick could not be saved: %1</source>
        <translation>스틱의 측정값을 저장할 수 없습니다: %1</translation>
    </message>
    <message>
        <source>What was unpacked for the import cannot be removed: %1</source>
        <translation>가져오기를 위해 푼 것을 지울 수 없습니다. %1</translation>
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
        <translation>팰컨의 모터를 지켜보는 프로그램이 끝나서 모터를 켜지 않습니다. 장치를 다시 시작하세요.</translation>
    </message>
    <message>
        <source>Pictures in the formats HEIC and AVIF need the library libheif (Debian: libheif1), which is not installed: install it or save the picture as JPEG.</source>
        <translation>HEIC와 AVIF 형식의 사진에는 libheif 라이브러리(Debian: libheif1)가 필요하지만 여기에는 없습니다. 설치하거나 사진을 JPEG로 저장하세요.</translation>
    </message>
    <message>
        <source>The %1 file holds a kind of picture that cannot be decoded here: save it as JPEG.</source>
        <translation>%1 파일에 여기서 디코딩할 수 없는 종류의 사진이 들어 있습니다. JPEG로 저장하세요.</translation>
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
        <translation>같은 파일이 두 번 들어 있습니다: “%1”.</translation>
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
        <source>That is more than can be imported at once: import the folder that the files are in.</source>
        <translation>한 번에 가져올 수 있는 것보다 많습니다. 파일이 들어 있는 폴더를 가져오세요.</translation>
    </message>
    <message>
        <source>it lists more people, words or recordings than any photograph has.</source>
        <translation>어떤 사진에 있는 것보다 많은 사람, 낱말 또는 녹음을 나열합니다.</translation>
    </message>
    <message>
        <source>Such files are decoded in a process that can do nothing else, and this system does not allow that (%1): save the picture as JPEG.</source>
        <translation>이런 파일은 다른 일은 할 수 없는 프로세스에서 디코딩하는데, 이 시스템에서는 그렇게 할 수 없습니다(%1). 사진을 JPEG로 저장하세요.</translation>
    </message>
    <message>
        <source>The picture cannot be decoded: decoding it broke off. The file may be damaged.</source>
        <translation>사진을 디코딩할 수 없습니다. 디코딩이 중단되었습니다. 파일이 손상되었을 수 있습니다.</translation>
    </message>
    <message>
        <source>The picture takes too long to decode; it was not read.</source>
        <translation>사진을 디코딩하는 데 시간이 너무 오래 걸려 읽지 않았습니다.</translation>
    </message>
    <message>
        <source>The program %1, which decodes such files, cannot be started: install TouchPhoto again.</source>
        <translation>이런 파일을 디코딩하는 프로그램(%1)을 시작할 수 없습니다. TouchPhoto를 다시 설치하세요.</translation>
    </message>
    <message>
        <source>its sound cannot be decoded: decoding it broke off. It may be damaged.</source>
        <translation>소리를 디코딩할 수 없습니다. 디코딩이 중단되었습니다. 손상되었을 수 있습니다.</translation>
    </message>
    <message>
        <source>its sound takes too long to decode.</source>
        <translation>소리를 디코딩하는 데 시간이 너무 오래 걸립니다.</translation>
    </message>
    <message>
        <source>it is not a photograph of a kind that can be read here.</source>
        <translation>여기에서 읽을 수 있는 종류의 사진이 아닙니다.</translation>
    </message>
    <message>
        <source>%1 faces were named %2</source>
        <translation>얼굴 %1개에 %2 이름을 붙임</translation>
    </message>
    <message>
        <source>Since then the groups of faces have changed, so this cannot be undone.</source>
        <translation>그 뒤로 얼굴 묶음이 바뀌어 되돌릴 수 없습니다.</translation>
    </message>
    <message>
        <source>These faces are not grouped so any more.</source>
        <translation>이 얼굴들은 더 이상 그렇게 묶여 있지 않습니다.</translation>
    </message>
    <message>
        <source>a face is not that of %1</source>
        <translation>얼굴 하나가 %1의 얼굴이 아님</translation>
    </message>
    <message>
        <source>a face was taken out of its group</source>
        <translation>얼굴 하나를 묶음에서 뺌</translation>
    </message>
    <message>
        <source>Another program is using the camera. Close it and try again.</source>
        <translation>다른 프로그램이 카메라를 쓰고 있습니다. 그 프로그램을 닫고 다시 시도하세요.</translation>
    </message>
    <message>
        <source>No camera was found on this computer.</source>
        <translation>이 컴퓨터에서 카메라를 찾지 못했습니다.</translation>
    </message>
    <message>
        <source>The camera gives no pictures.</source>
        <translation>카메라에서 화면이 오지 않습니다.</translation>
    </message>
    <message>
        <source>The camera gives pictures that TouchPhoto cannot read.</source>
        <translation>카메라가 TouchPhoto에서 읽을 수 없는 형식을 보냅니다.</translation>
    </message>
    <message>
        <source>The camera was unplugged.</source>
        <translation>카메라 연결이 끊어졌습니다.</translation>
    </message>
    <message>
        <source>The system does not let TouchPhoto use the camera.</source>
        <translation>시스템이 TouchPhoto의 카메라 사용을 허용하지 않습니다.</translation>
    </message>
    <message>
        <source>the recording of background sounds</source>
        <translation>주변 소리 녹음</translation>
    </message>
    <message>
        <source>the recording of background sounds (%1)</source>
        <translation>주변 소리 녹음(%1)</translation>
    </message>
    <message>
        <source>the recording of the place</source>
        <translation>장소 녹음</translation>
    </message>
    <message>
        <source>the recording of the place (%1)</source>
        <translation>장소 녹음(%1)</translation>
    </message>
    <message>
        <source>the recording of who %1 is</source>
        <translation>%1: 누구인지 알려 주는 녹음</translation>
    </message>
    <message>
        <source>the recording of who it is</source>
        <translation>누구인지 알려 주는 녹음</translation>
    </message>
    <message>
        <source>it was changed meanwhile.</source>
        <translation>그사이 내용이 바뀌었습니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be gone on with: its trial %2 is not the one that the study has planned.</source>
        <translation>“%1”: 이어서 할 수 없습니다. 시행 %2: 연구에서 계획한 것과 다릅니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has the trials of participant %2; name it &quot;%3&quot;.</source>
        <translation>“%1”: 참가자 %2의 시행이 들어 있습니다. 파일 이름을 “%3” 그대로 바꾸세요.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: the last trial was being written when the program ended; it is done again.</source>
        <translation>“%1”: 프로그램이 끝날 때 마지막 시행을 쓰고 있었습니다. 그 시행은 다시 합니다.</translation>
    </message>
    <message>
        <source>Another program is running the study in &quot;%1&quot;; end it there, or choose another folder.</source>
        <translation>다른 프로그램이 “%1”에서 연구를 진행하고 있습니다. 그 프로그램을 끝내거나 다른 폴더를 선택하세요.</translation>
    </message>
    <message>
        <source>In &quot;%1&quot; lies a study of another experiment, or of another version of it; choose another folder for this one.</source>
        <translation>“%1”에는 다른 실험이나 그 실험의 다른 판으로 한 연구가 있습니다. 이 연구에는 다른 폴더를 선택하세요.</translation>
    </message>
    <message>
        <source>In &quot;%1&quot; lies a study with another seed or other participants; choose another folder for this one.</source>
        <translation>“%1”에는 시작 값이나 참가자가 다른 연구가 있습니다. 이 연구에는 다른 폴더를 선택하세요.</translation>
    </message>
    <message>
        <source>Line %1 of the study&apos;s terms %2.</source>
        <translation>연구 설정 %1번째 줄: %2.</translation>
    </message>
    <message>
        <source>Line %1 of the table of sittings %2.</source>
        <translation>참가 기록 표 %1번째 줄: %2.</translation>
    </message>
    <message>
        <source>Participant %1: %2 trials of %3, %4 of them done again.</source>
        <translation>참가자 %1: 시행 %3회 중 %2회, 그중 %4회 다시 함.</translation>
    </message>
    <message>
        <source>Participant %1: %2 trials of %3, %4 of them done again; %5 are missing.</source>
        <translation>참가자 %1: 시행 %3회 중 %2회, 그중 %4회 다시 함. %5회가 남았습니다.</translation>
    </message>
    <message>
        <source>Participant %1: %2 trials of %3.</source>
        <translation>참가자 %1: 시행 %3회 중 %2회.</translation>
    </message>
    <message>
        <source>Participant %1: %2 trials of %3; %4 are missing.</source>
        <translation>참가자 %1: 시행 %3회 중 %2회. %4회가 남았습니다.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be read.</source>
        <translation>폴더 “%1”: 읽을 수 없습니다.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; has other files in it; a study begins in an empty one.</source>
        <translation>폴더 “%1”: 다른 파일이 있습니다. 연구는 빈 폴더에서 시작합니다.</translation>
    </message>
    <message>
        <source>The study cannot write &quot;%1&quot;: %2</source>
        <translation>연구에서 “%1” 파일을 쓸 수 없습니다: %2</translation>
    </message>
    <message>
        <source>The study has more than %1 participants.</source>
        <translation>연구의 참가자가 %1명을 넘습니다.</translation>
    </message>
    <message>
        <source>The study in &quot;%1&quot; cannot go on: its file &quot;%2&quot; is missing.</source>
        <translation>“%1”의 연구를 이어서 할 수 없습니다: 파일 “%2”: 없습니다.</translation>
    </message>
    <message>
        <source>The study&apos;s terms do not say who takes part: a line &quot;participants: people&quot; or &quot;participants: simulated&quot; is missing.</source>
        <translation>연구 설정에 누가 참가하는지 없습니다: “participants: people” 또는 “participants: simulated” 줄이 빠졌습니다.</translation>
    </message>
    <message>
        <source>The study&apos;s terms have no seed: a line &quot;seed: NUMBER&quot; is missing.</source>
        <translation>연구 설정에 시작 값이 없습니다: “seed: 숫자” 줄이 빠졌습니다.</translation>
    </message>
    <message>
        <source>The table of sittings has other columns than %1.</source>
        <translation>참가 기록 표의 열이 다음과 다릅니다: %1.</translation>
    </message>
    <message>
        <source>The table of sittings is longer than %1 MB.</source>
        <translation>참가 기록 표가 %1 MB보다 깁니다.</translation>
    </message>
    <message>
        <source>The terms of the study are longer than %1 KB.</source>
        <translation>연구 설정이 %1 KB보다 깁니다.</translation>
    </message>
    <message>
        <source>The trial was not kept: it is not the one that comes next.</source>
        <translation>시행을 저장하지 않았습니다: 다음 차례의 시행이 아닙니다.</translation>
    </message>
    <message>
        <source>The trial was not kept: the finger&apos;s path in it is none.</source>
        <translation>시행을 저장하지 않았습니다: 손가락이 지나간 길이 올바르지 않습니다.</translation>
    </message>
    <message>
        <source>There is no study in &quot;%1&quot;.</source>
        <translation>“%1”에는 연구가 없습니다.</translation>
    </message>
    <message>
        <source>has another number of cells than there are columns</source>
        <translation>셀의 수가 열의 수와 다릅니다</translation>
    </message>
    <message>
        <source>is not understood</source>
        <translation>이해할 수 없습니다</translation>
    </message>
    <message>
        <source>it is gone.</source>
        <translation>없어졌습니다.</translation>
    </message>
    <message>
        <source>needs a whole number</source>
        <translation>정수가 필요합니다</translation>
    </message>
    <message>
        <source>needs people or simulated</source>
        <translation>people 또는 simulated가 필요합니다</translation>
    </message>
    <message>
        <source>needs whole numbers from 1 to 1000000 in its first two cells</source>
        <translation>처음 두 셀에 1에서 1000000까지의 정수가 필요합니다</translation>
    </message>
    <message>
        <source>participant %1 is in &quot;%2&quot; already.</source>
        <translation>참가자 %1: 이미 “%2”에 있습니다.</translation>
    </message>
    <message>
        <source>says it a second time</source>
        <translation>같은 것을 두 번 말합니다</translation>
    </message>
    <message>
        <source>the last trial was being written when the program ended; it is left out.</source>
        <translation>프로그램이 끝날 때 마지막 시행을 쓰고 있었습니다. 그 시행은 뺐습니다.</translation>
    </message>
    <message>
        <source>the trials of more than one participant are in it.</source>
        <translation>여러 참가자의 시행이 들어 있습니다.</translation>
    </message>
    <message>
        <source>A face cannot be followed from a start to an end; the experiment %1 needs the task: name.</source>
        <translation>얼굴은 시작에서 끝까지 따라갈 수 없습니다. 실험 “%1”에는 과제 “name”이 필요합니다.</translation>
    </message>
    <message>
        <source>A shape %1 mm wide and %2 mm high does not fit on a surface of %3 x %4 mm.</source>
        <translation>너비 %1 mm, 높이 %2 mm인 도형은 %3 x %4 mm 크기의 영역에 들어가지 않습니다.</translation>
    </message>
    <message>
        <source>The experiment %1 must have either a path, a shape or a face in every trial, as a factor or set for all.</source>
        <translation>실험 “%1”의 모든 시행에는 경로, 도형, 얼굴 가운데 하나만 있어야 합니다. 요인으로 두거나 전체에 정해 주세요.</translation>
    </message>
    <message>
        <source>The experiment %1 needs faces, and none are there.</source>
        <translation>실험 “%1”에는 얼굴이 필요하지만 얼굴이 없습니다.</translation>
    </message>
    <message>
        <source>The trial was not kept: a study has at most %1 participants.</source>
        <translation>시행을 저장하지 않았습니다: 연구의 참가자는 최대 %1명입니다.</translation>
    </message>
    <message>
        <source>The trial was not kept: its error, time or answer is none that there can be.</source>
        <translation>시행을 저장하지 않았습니다: 오차나 시간이나 답이 있을 수 없는 값입니다.</translation>
    </message>
    <message>
        <source>A face of the experiment is not there.</source>
        <translation>실험에 쓸 얼굴 하나가 없습니다.</translation>
    </message>
    <message>
        <source>No face was found in &quot;%1&quot;.</source>
        <translation>“%1”에서 얼굴을 찾지 못했습니다.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; has too few people with every expression: %2. Name the files after person and expression, such as anna_smiling.jpg.</source>
        <translation>폴더 “%1”: 모든 표정이 있는 사람이 너무 적습니다(%2명). 파일 이름을 anna_smiling.jpg처럼 사람과 표정으로 지어 주세요.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; has too many files.</source>
        <translation>폴더 “%1”: 파일이 너무 많습니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; belongs to no trial that was kept.</source>
        <translation>“%1”: 저장된 어떤 시행에도 속하지 않습니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has %2 samples; in the trial&apos;s time there are %3 at least.</source>
        <translation>“%1”: 측정값이 %2개입니다. 시행 시간에는 적어도 %3개가 있어야 합니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was being written when the program ended; it goes when the study goes on.</source>
        <translation>“%1”: 프로그램이 끝날 때 쓰고 있던 파일입니다. 연구를 계속하면 없어집니다.</translation>
    </message>
    <message>
        <source>A trial was running when the program ended; it is done again.</source>
        <translation>프로그램이 끝날 때 시행이 진행 중이었습니다. 그 시행은 다시 합니다.</translation>
    </message>
    <message>
        <source>Line %1 of the finger&apos;s path goes back in time.</source>
        <translation>손가락 경로의 %1번째 줄: 시간이 거꾸로 갑니다.</translation>
    </message>
    <message>
        <source>Line %1 of the finger&apos;s path has no five numbers.</source>
        <translation>손가락 경로의 %1번째 줄: 숫자 다섯 개가 없습니다.</translation>
    </message>
    <message>
        <source>Participant %1: nobody has noted with which machine the first trial was done.</source>
        <translation>참가자 %1: 첫 시행에 쓴 장치가 기록되어 있지 않습니다.</translation>
    </message>
    <message>
        <source>Participant %1: the finger&apos;s path is missing in these trials: %2.</source>
        <translation>참가자 %1: 다음 시행의 손가락 경로가 없습니다: %2.</translation>
    </message>
    <message>
        <source>Participant %1: trial %2 is not the one that was planned; protocol, seed or table were changed since.</source>
        <translation>참가자 %1: %2번 시행이 계획과 다릅니다. 그 뒤에 실험 계획, 시작 값 또는 표가 바뀌었습니다.</translation>
    </message>
    <message>
        <source>The finger&apos;s path cannot be unpacked: %1</source>
        <translation>손가락 경로의 압축을 풀 수 없습니다: %1</translation>
    </message>
    <message>
        <source>The finger&apos;s path has more than %1 samples.</source>
        <translation>손가락 경로의 측정값이 %1개보다 많습니다.</translation>
    </message>
    <message>
        <source>The finger&apos;s path has other columns than time_s,x_mm,y_mm,fx_n,fy_n.</source>
        <translation>손가락 경로의 열이 time_s,x_mm,y_mm,fx_n,fy_n과 다릅니다.</translation>
    </message>
    <message>
        <source>The folder &quot;%1&quot; cannot be made: %2</source>
        <translation>폴더 “%1”: 만들 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The last line of the finger&apos;s path is not whole.</source>
        <translation>손가락 경로의 마지막 줄이 온전하지 않습니다.</translation>
    </message>
    <message>
        <source>The line %1 reaches more than 1 km from the middle of the surface, too far to be felt exactly.</source>
        <translation>표면 가운데에서 1 km 넘게 뻗어 있어 정확히 느낄 수 없는 선: %1.</translation>
    </message>
    <message>
        <source>The page &quot;%1&quot; cannot be written: %2</source>
        <translation>페이지 “%1”: 쓸 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The plot %1 cannot be written: %2</source>
        <translation>그래프 %1: 쓸 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The table %1 cannot be written: %2</source>
        <translation>표 %1: 쓸 수 없습니다. %2</translation>
    </message>
    <message>
        <source>There is no file &quot;%1&quot;: nobody knows the seed of the study, or whether its participants are simulated.</source>
        <translation>파일 “%1”: 없습니다. 연구의 시작 값과 참가자가 모의 참가자인지를 알 수 없습니다.</translation>
    </message>
    <message>
        <source>it ends too soon.</source>
        <translation>너무 일찍 끝납니다.</translation>
    </message>
    <message>
        <source>it holds more than such a file may.</source>
        <translation>이런 파일이 담을 수 있는 것보다 많이 들어 있습니다.</translation>
    </message>
    <message>
        <source>there is something behind its end.</source>
        <translation>끝난 뒤에 다른 내용이 있습니다.</translation>
    </message>
    <message>
        <source>The video &quot;%1&quot; cannot be played: %2</source>
        <translation>동영상 “%1”: 재생할 수 없습니다. %2</translation>
    </message>
    <message>
        <source>it has no pictures.</source>
        <translation>화면이 없습니다.</translation>
    </message>
    <message>
        <source>its pictures are of a kind that cannot be decoded here (%1).</source>
        <translation>여기서 디코딩할 수 없는 종류의 화면입니다(%1).</translation>
    </message>
    <message>
        <source>its pictures cannot be decoded.</source>
        <translation>화면을 디코딩할 수 없습니다.</translation>
    </message>
    <message>
        <source>its pictures cannot be decoded: decoding them broke off. It may be damaged.</source>
        <translation>화면을 디코딩할 수 없습니다. 디코딩이 중단되었습니다. 손상되었을 수 있습니다.</translation>
    </message>
    <message>
        <source>its pictures take too long to decode.</source>
        <translation>화면을 디코딩하는 데 시간이 너무 오래 걸립니다.</translation>
    </message>
    <message>
        <source>nothing of its pictures can be decoded.</source>
        <translation>화면을 하나도 디코딩할 수 없습니다.</translation>
    </message>
    <message>
        <source>A friction map has between 0 and 1000 dots a millimetre.</source>
        <translation>마찰 지도의 점은 밀리미터당 0개보다 많고 1000개 이하입니다.</translation>
    </message>
    <message>
        <source>A ridge of %1 mm is narrower than two dots at %2 dots a millimetre and would have gaps; choose more dots or a wider ridge.</source>
        <translation>%1 mm 돌기는 밀리미터당 점 %2개에서 점 두 개보다 좁아 끊어집니다. 점을 늘리거나 더 넓은 돌기를 선택하세요.</translation>
    </message>
    <message>
        <source>At %1 dots a millimetre the map would be %2 × %3 dots, more than can be drawn; choose fewer dots a millimetre.</source>
        <translation>밀리미터당 점 %1개이면 지도가 %2 × %3개의 점이 되어 그릴 수 없습니다. 밀리미터당 점을 줄이세요.</translation>
    </message>
    <message>
        <source>The friction of a ridge and of a stripe must be numbers from 0 to 1.</source>
        <translation>돌기와 줄무늬의 마찰은 0에서 1 사이의 수여야 합니다.</translation>
    </message>
    <message>
        <source>The speed of a moving finger must be a number above that of a resting one.</source>
        <translation>움직이는 손가락의 속도는 쉬는 손가락의 속도보다 큰 수여야 합니다.</translation>
    </message>
    <message>
        <source>The width of a ridge and of a stripe must be numbers of millimetres above zero.</source>
        <translation>돌기와 줄무늬의 너비는 0보다 큰 밀리미터 수여야 합니다.</translation>
    </message>
    <message>
        <source>There is not enough memory for a map of so many dots; choose fewer dots a millimetre.</source>
        <translation>점이 이렇게 많은 지도를 만들 메모리가 부족합니다. 밀리미터당 점을 줄이세요.</translation>
    </message>
    <message>
        <source>There is no touch output &quot;%1&quot; now. Check that it is plugged in; &quot;touchphoto-lab devices&quot; lists what is there.</source>
        <translation>촉각 출력 “%1”: 지금 없습니다. 꽂혀 있는지 확인하세요. “touchphoto-lab devices”가 있는 장치를 알려 줍니다.</translation>
    </message>
    <message>
        <source>No Steam Controller is switched on near its receiver. Press its middle button and try again.</source>
        <translation>수신기 가까이에 켜져 있는 Steam Controller가 없습니다. 가운데 단추를 누르고 다시 해 보세요.</translation>
    </message>
    <message>
        <source>Steam Controller</source>
        <translation>Steam Controller</translation>
    </message>
    <message>
        <source>Steam Controller by radio: its touch pads</source>
        <translation>무선 Steam Controller: 터치패드</translation>
    </message>
    <message>
        <source>Steam Controller: its touch pads</source>
        <translation>Steam Controller: 터치패드</translation>
    </message>
    <message>
        <source>Steam Deck</source>
        <translation>Steam Deck</translation>
    </message>
    <message>
        <source>Steam Deck: its touch pads</source>
        <translation>Steam Deck: 터치패드</translation>
    </message>
    <message>
        <source>The %1 does not answer. Close other programs that use it, such as Steam, and try again.</source>
        <translation>장치가 응답하지 않습니다: %1. 이 장치를 쓰는 Steam 같은 다른 프로그램을 닫고 다시 해 보세요.</translation>
    </message>
    <message>
        <source>The %1 does not take the ticks. Close other programs that use it, such as Steam.</source>
        <translation>장치가 촉각 신호를 받지 않습니다: %1. 이 장치를 쓰는 Steam 같은 다른 프로그램을 닫으세요.</translation>
    </message>
    <message>
        <source>The Steam Controller was switched off, or is too far from its receiver. Press its middle button.</source>
        <translation>Steam Controller가 꺼졌거나 수신기에서 너무 멀리 있습니다. 가운데 단추를 누르세요.</translation>
    </message>
    <message>
        <source>The touch pad with haptics cannot be used: %1.</source>
        <translation>햅틱 터치패드를 사용할 수 없습니다: %1.</translation>
    </message>
    <message>
        <source>The touch pad with haptics does not take the ticks. Close other programs that use it.</source>
        <translation>햅틱 터치패드가 촉각 신호를 받지 않습니다. 이 장치를 쓰는 다른 프로그램을 닫으세요.</translation>
    </message>
    <message>
        <source>it does not say which ticks it has</source>
        <translation>어떤 촉각 신호가 있는지 알려 주지 않습니다</translation>
    </message>
    <message>
        <source>it has no tick that ends by itself</source>
        <translation>저절로 끝나는 촉각 신호가 없습니다</translation>
    </message>
    <message>
        <source>it ticks by itself only and takes no ticks from a program</source>
        <translation>촉각 신호를 스스로만 내고 프로그램에서는 받지 않습니다</translation>
    </message>
    <message>
        <source>touch pad with haptics</source>
        <translation>햅틱 터치패드</translation>
    </message>
    <message>
        <source>what it says of its ticks cannot be right</source>
        <translation>촉각 신호에 대해 알려 준 내용이 맞을 수 없습니다</translation>
    </message>
    <message>
        <source>what it says of itself cannot be read</source>
        <translation>스스로에 대해 알려 준 내용을 읽을 수 없습니다</translation>
    </message>
    <message>
        <source>Other programs use all that the %1 can play. Close them and try again.</source>
        <translation>다른 프로그램이 장치를 다 쓰고 있습니다: %1. 그 프로그램을 닫고 다시 해 보세요.</translation>
    </message>
    <message>
        <source>The %1 answers too slowly to tell of lines. Unplug it and plug it in again; if that does not help, choose another output.</source>
        <translation>장치가 선을 알리기에는 너무 느리게 답합니다: %1. 뽑았다가 다시 꽂으세요. 그래도 안 되면 다른 촉각 출력을 선택하세요.</translation>
    </message>
    <message>
        <source>The %1 cannot be used on this system: its vibration is used on Linux only.</source>
        <translation>이 시스템에서는 이 장치를 쓸 수 없습니다: %1. 진동은 리눅스에서만 씁니다.</translation>
    </message>
    <message>
        <source>The %1 did not play what it was told. Close other programs that use it, unplug it and plug it in again.</source>
        <translation>장치가 시킨 대로 진동하지 않았습니다: %1. 이 장치를 쓰는 다른 프로그램을 닫고, 장치를 뽑았다가 다시 꽂으세요.</translation>
    </message>
    <message>
        <source>drawn finger</source>
        <translation>그려진 손가락</translation>
    </message>
    <message>
        <source>game pad</source>
        <translation>게임 패드</translation>
    </message>
    <message>
        <source>vibration motor of this machine</source>
        <translation>이 컴퓨터의 진동 모터</translation>
    </message>
    <message>
        <source>vibration of this phone</source>
        <translation>이 전화기의 진동</translation>
    </message>
    <message>
        <source>Dark glasses hide the eyes, so their contours are a guess.</source>
        <translation>선글라스가 눈을 가려서 눈의 윤곽은 짐작한 것입니다.</translation>
    </message>
    <message>
        <source>dark glasses hide it</source>
        <translation>선글라스에 가려져</translation>
    </message>
    <message>
        <source>The way after which a line is told of again must be a number of millimetres, zero or more.</source>
        <translation>선을 다시 알리기까지 움직일 거리는 0 이상의 밀리미터 수여야 합니다.</translation>
    </message>
    <message>
        <source>simulated motor</source>
        <translation>모의 모터</translation>
    </message>
    <message>
        <source>The file &quot;%1&quot; is larger than %2 KB; that is more than such a file may be.</source>
        <translation>파일 “%1”: %2 KB보다 큽니다. 이런 파일로는 너무 큽니다.</translation>
    </message>
    <message>
        <source>The conflict copy &quot;%1&quot; cannot be read: %2 It stays where it is.</source>
        <translation>충돌 사본 “%1”: 읽을 수 없습니다. %2 그 자리에 그대로 둡니다.</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; of &quot;%2&quot; is another one in the album; that one stays.</source>
        <translation>녹음 “%1”(“%2”): 앨범에 있는 것과 다릅니다. 앨범의 것이 남습니다.</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; of &quot;%2&quot; was not imported: %3</source>
        <translation>녹음 “%1”(“%2”): 가져오지 못했습니다. %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is hidden, and an album leaves what is hidden alone.</source>
        <translation>“%1”: 숨긴 파일입니다. 앨범은 숨긴 파일을 건드리지 않습니다.</translation>
    </message>
    <message>
        <source>The JPEG file goes over its picture more often than any program does; it was not read.</source>
        <translation>이 JPEG 파일은 어떤 프로그램보다 그림을 여러 번 거칩니다. 읽지 않았습니다.</translation>
    </message>
    <message>
        <source>The file &quot;%1&quot; cannot be read: %2</source>
        <translation>파일 “%1”: 읽을 수 없습니다. %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be read: %2</source>
        <translation>“%1”: 읽을 수 없습니다. %2</translation>
    </message>
    <message>
        <source>%1 Nothing was exported.</source>
        <translation>%1 아무것도 내보내지 않았습니다.</translation>
    </message>
    <message>
        <source>The recording cannot be restored: %1</source>
        <translation>녹음을 되돌릴 수 없습니다: %1</translation>
    </message>
    <message>
        <source>The recordings of &quot;%1&quot; were not imported: %2</source>
        <translation>“%1”의 녹음을 가져오지 못했습니다. %2</translation>
    </message>
    <message>
        <source>The trash &quot;%1&quot; cannot be read: %2</source>
        <translation>휴지통 “%1”: 읽을 수 없습니다. %2</translation>
    </message>
    <message>
        <source>What belongs to &quot;%1&quot; cannot be read: %2</source>
        <translation>“%1”에 딸린 것을 읽을 수 없습니다. %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not in the trash any more.</source>
        <translation>“%1”: 휴지통에 더 이상 없습니다.</translation>
    </message>
</context>
<context>
    <name>SettingsPage</name>
    <message>
        <source>Tab moves from setting to setting, Space or Enter changes one, the arrow keys move a slider. Control+Z undoes the last change. Every change is saved at once.</source>
        <translation>탭 키로 설정 사이를 이동하고, 스페이스바나 엔터 키로 설정을 바꾸며, 화살표 키로 슬라이더를 움직입니다. Ctrl+Z는 마지막 변경을 되돌립니다. 변경은 바로 저장됩니다.</translation>
    </message>
    <message>
        <source>Speech and sound</source>
        <translation>음성과 소리</translation>
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
        <source>Sound effects</source>
        <translation>효과음</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>화면 모양</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>색</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>글자 크기</translation>
    </message>
    <message>
        <source>%1 percent</source>
        <translation>%1퍼센트</translation>
    </message>
    <message>
        <source>Animations</source>
        <translation>애니메이션</translation>
    </message>
    <message>
        <source>Who uses the tablet most</source>
        <translation>태블릿을 주로 쓰는 사람</translation>
    </message>
    <message>
        <source>What is felt</source>
        <translation>촉감</translation>
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
        <source>Guide when there is no force</source>
        <translation>힘이 없을 때의 길잡이</translation>
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
        <source>Rebuild the index</source>
        <translation>색인 다시 만들기</translation>
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
        <source>Key: Control+Z</source>
        <translation>Ctrl+Z 키</translation>
    </message>
    <message>
        <source>Ask me the five questions again</source>
        <translation>처음의 다섯 가지 질문을 다시 하기</translation>
    </message>
    <message>
        <source>Reset all settings</source>
        <translation>모든 설정 초기화</translation>
    </message>
    <message>
        <source>The album&apos;s folders stay. Can be undone</source>
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
        <source>You touch the four corners of the screen with the device</source>
        <translation>장치로 화면의 네 모서리를 건드립니다</translation>
    </message>
    <message>
        <source>Try the strongest force</source>
        <translation>최대 힘 느껴 보기</translation>
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
        <translation>힘 스틱 측정</translation>
    </message>
    <message>
        <source>How strong it is and which way it pulls. You need a kitchen scale or a luggage scale</source>
        <translation>얼마나 세고 어느 쪽으로 당기는지. 주방 저울이나 여행 가방 저울이 필요합니다</translation>
    </message>
    <message>
        <source>Descriptions of photographs</source>
        <translation>사진 설명</translation>
    </message>
    <message>
        <source>What is said first</source>
        <translation>먼저 말할 것</translation>
    </message>
    <message>
        <source>Compare faces, to offer names</source>
        <translation>얼굴을 비교해 이름 제안</translation>
    </message>
    <message>
        <source>What ticks under the finger</source>
        <translation>손가락 아래에서 톡톡 치는 장치</translation>
    </message>
    <message>
        <source>Strength of ticks</source>
        <translation>톡톡 치는 세기</translation>
    </message>
    <message>
        <source>Sharpness of ticks</source>
        <translation>톡톡 치는 날카로움</translation>
    </message>
    <message>
        <source>How late ticks are felt</source>
        <translation>톡톡 치는 느낌이 늦는 정도</translation>
    </message>
    <message>
        <source>%1 milliseconds</source>
        <translation>%1밀리초</translation>
    </message>
    <message>
        <source>Feel a tick now</source>
        <translation>지금 한 번 느껴 보기</translation>
    </message>
    <message>
        <source>I feel it</source>
        <translation>느꼈어요</translation>
    </message>
    <message>
        <source>Measure how late ticks are felt</source>
        <translation>톡톡 치는 느낌이 얼마나 늦는지 측정</translation>
    </message>
    <message>
        <source>Key: Space</source>
        <translation>스페이스바</translation>
    </message>
    <message>
        <source>You press Space when you feel a tick</source>
        <translation>톡 치는 것이 느껴지면 스페이스바를 누릅니다</translation>
    </message>
</context>
<context>
    <name>SetupView</name>
    <message>
        <source>Experiment</source>
        <translation>실험</translation>
    </message>
    <message>
        <source>Open an experiment&apos;s file</source>
        <translation>실험 파일 열기</translation>
    </message>
    <message>
        <source>Another experiment is a file, not a program. Key: O</source>
        <translation>다른 실험은 프로그램이 아니라 파일입니다. O 키</translation>
    </message>
    <message>
        <source>Choose the folder with faces</source>
        <translation>얼굴 폴더 선택</translation>
    </message>
    <message>
        <source>Photographs or drawings named after person and expression. Key: G</source>
        <translation>사람과 표정으로 이름을 지은 사진이나 그림. G 키</translation>
    </message>
    <message>
        <source>Choose another folder for the study</source>
        <translation>연구를 저장할 다른 폴더 선택</translation>
    </message>
    <message>
        <source>One with this study in it is continued. Key: F</source>
        <translation>이 연구가 들어 있는 폴더면 이어서 진행합니다. F 키</translation>
    </message>
    <message>
        <source>Previous participant</source>
        <translation>이전 참가자</translation>
    </message>
    <message>
        <source>Key: Minus</source>
        <translation>빼기 키</translation>
    </message>
    <message>
        <source>Next participant</source>
        <translation>다음 참가자</translation>
    </message>
    <message>
        <source>Key: Plus</source>
        <translation>더하기 키</translation>
    </message>
    <message>
        <source>What moves the finger</source>
        <translation>손가락을 움직이는 것</translation>
    </message>
    <message>
        <source>I consent to the force that this study asks for</source>
        <translation>이 연구에 필요한 힘에 동의합니다</translation>
    </message>
    <message>
        <source>Show the scene, to try it out; nothing is kept</source>
        <translation>시험 삼아 장면 보기, 저장하지 않음</translation>
    </message>
    <message>
        <source>Start with participant %1</source>
        <translation>참가자 %1번 시작</translation>
    </message>
    <message>
        <source>Asks for consent first. Key: S</source>
        <translation>먼저 동의를 구합니다. S 키</translation>
    </message>
    <message>
        <source>Faces: %1</source>
        <translation>얼굴: %1</translation>
    </message>
    <message>
        <source>The study&apos;s folder: %1</source>
        <translation>연구 폴더: %1</translation>
    </message>
    <message>
        <source>The participant&apos;s number, in place of a name. Key: N</source>
        <translation>이름 대신 쓰는 참가자 번호. 키: N</translation>
    </message>
    <message>
        <source>How the study stands</source>
        <translation>연구 진행 상황</translation>
    </message>
    <message>
        <source>Trials, errors and times so far, and what is wrong in the folder. Key: C</source>
        <translation>지금까지의 시행, 오차와 시간, 그리고 폴더의 문제. 키: C</translation>
    </message>
    <message>
        <source>Make the report</source>
        <translation>보고서 만들기</translation>
    </message>
    <message>
        <source>Tables, plots and a page, beside the study&apos;s folder. Key: R</source>
        <translation>연구 폴더 옆에 표, 그래프와 페이지를 만듭니다. 키: R</translation>
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
        <source>Says what you can do here. Key: F1</source>
        <translation>여기서 할 수 있는 일을 말해 줍니다. F1 키</translation>
    </message>
    <message>
        <source>Last sentence</source>
        <translation>마지막 문장</translation>
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
        <source>Leads the finger round every feature, naming each one first. Key: T</source>
        <translation>부위 이름을 먼저 말하고, 손가락을 이끌어 모든 부위를 차례로 돕니다. T 키</translation>
    </message>
    <message>
        <source>Where am I?</source>
        <translation>현재 위치</translation>
    </message>
    <message>
        <source>Says which face and feature, the direction and the distance. Key: W</source>
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
        <source>Stops tour, speech and force. Key: Escape</source>
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
        <source>Key: Shift+Z</source>
        <translation>Shift+Z 키</translation>
    </message>
    <message>
        <source>Next feature</source>
        <translation>다음 부위</translation>
    </message>
    <message>
        <source>Puts the finger on it. Key: Tab</source>
        <translation>그 위에 손가락을 놓습니다. 탭 키</translation>
    </message>
    <message>
        <source>Next face</source>
        <translation>다음 얼굴</translation>
    </message>
    <message>
        <source>Fits one face after another into the touch surface. Key: F</source>
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
        <source>The next one in the album with a face. Key: N</source>
        <translation>앨범에서 얼굴이 있는 다음 사진. N 키</translation>
    </message>
    <message>
        <source>Previous photograph</source>
        <translation>이전 사진</translation>
    </message>
    <message>
        <source>Key: Shift+N</source>
        <translation>Shift+N 키</translation>
    </message>
    <message>
        <source>Ticks: %1</source>
        <translation>톡톡: %1</translation>
    </message>
    <message>
        <source>Ticks on</source>
        <translation>톡톡 켜기</translation>
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
    <name>StudyPage</name>
    <message>
        <source>Space starts and ends a trial, and goes on after a break. A number key gives an answer. Arrow keys move the hand by 2 millimetres, with Shift by 10, where no device does. P pauses, W says where you are. Escape stops; the force is then off at once.</source>
        <translation>스페이스바는 시행을 시작하고 끝내며, 휴식 뒤에는 계속합니다. 숫자 키로 답합니다. 장치가 없으면 화살표 키로 손을 2밀리미터씩, Shift와 함께 누르면 10밀리미터씩 움직입니다. P는 일시 정지, W는 현재 위치입니다. Escape 키를 누르면 멈추고 힘이 바로 꺼집니다.</translation>
    </message>
    <message>
        <source>Keys 1 to 9: experiment. O: an experiment&apos;s file. F: the study&apos;s folder. G: the folder with faces. N, Minus and Plus: participant. M: what moves the finger. L: consent to the force that the study needs. S: start. C: how the study stands. R: makes its report. W: says where you are.</source>
        <translation>1에서 9까지의 키: 실험. O: 실험 파일. F: 연구 폴더. G: 얼굴 폴더. N, 빼기와 더하기: 참가자. M: 손가락을 움직이는 것. L: 연구에 필요한 힘에 동의. S: 시작. C: 연구 진행 상황. R: 보고서 만들기. W: 현재 위치.</translation>
    </message>
</context>
<context>
    <name>StudySurface</name>
    <message>
        <source>Study surface</source>
        <translation>연구 터치 영역</translation>
    </message>
</context>
<context>
    <name>StudyWords</name>
    <message>
        <source>Following contours, by stiffness and range</source>
        <translation>강성과 범위에 따른 윤곽선 따라가기</translation>
    </message>
    <message>
        <source>Naming shapes of three sizes</source>
        <translation>세 가지 크기의 도형 맞히기</translation>
    </message>
    <message>
        <source>Naming the expressions of faces</source>
        <translation>얼굴 표정 맞히기</translation>
    </message>
    <message>
        <source>Following contours by the exact and the published law</source>
        <translation>정확한 유도 법칙과 논문의 유도 법칙으로 윤곽선 따라가기</translation>
    </message>
    <message>
        <source>Naming expressions by the exact and the published law</source>
        <translation>정확한 유도 법칙과 논문의 유도 법칙으로 표정 맞히기</translation>
    </message>
    <message>
        <source>Follow a line with your finger from its start to its end, as exactly and as fast as you can; a closed line once round. The trial ends by itself at the end of the line. If you think that you are there and nothing happens, press Space.</source>
        <translation>손가락으로 선을 시작점에서 끝점까지 되도록 정확하고 빠르게 따라가세요. 닫힌 선은 한 바퀴 돕니다. 선의 끝에 이르면 시행이 자동으로 끝납니다. 끝에 온 것 같은데 아무 일도 없으면 스페이스바를 누르세요.</translation>
    </message>
    <message>
        <source>Feel a face until you know how it looks. Then press Space, and the number of your answer.</source>
        <translation>어떤 표정인지 알 때까지 얼굴을 만져 보세요. 그런 다음 스페이스바를 누르고 답의 번호를 누르세요.</translation>
    </message>
    <message>
        <source>Feel a shape until you know which it is. Then press Space, and the number of your answer.</source>
        <translation>어떤 도형인지 알 때까지 만져 보세요. 그런 다음 스페이스바를 누르고 답의 번호를 누르세요.</translation>
    </message>
    <message>
        <source>Participant %1</source>
        <translation>참가자 %1번</translation>
    </message>
    <message>
        <source>%1 has done all %2 trials.</source>
        <translation>%1: 시행 %2회를 모두 마쳤습니다.</translation>
    </message>
    <message>
        <source>%1 has done %2 of %3 trials.</source>
        <translation>%1: 시행 %3회 중 %2회를 마쳤습니다.</translation>
    </message>
    <message>
        <source>Training %1 of %2</source>
        <translation>연습 %2회 중 %1번째</translation>
    </message>
    <message>
        <source>Trial %1 of %2</source>
        <translation>시행 %2회 중 %1번째</translation>
    </message>
    <message>
        <source>%1, once more</source>
        <translation>%1, 다시 한번</translation>
    </message>
    <message>
        <source>Feel the shape.</source>
        <translation>도형을 만져 보세요.</translation>
    </message>
    <message>
        <source>Follow the line.</source>
        <translation>선을 따라가세요.</translation>
    </message>
    <message>
        <source>Feel the face.</source>
        <translation>얼굴을 만져 보세요.</translation>
    </message>
    <message>
        <source>%1. %2 Press Space to start.</source>
        <translation>%1. %2 스페이스바를 누르면 시작합니다.</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>원</translation>
    </message>
    <message>
        <source>triangle</source>
        <translation>삼각형</translation>
    </message>
    <message>
        <source>square</source>
        <translation>정사각형</translation>
    </message>
    <message>
        <source>pentagon</source>
        <translation>오각형</translation>
    </message>
    <message>
        <source>hexagon</source>
        <translation>육각형</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>곡선</translation>
    </message>
    <message>
        <source>smiling</source>
        <translation>웃는 얼굴</translation>
    </message>
    <message>
        <source>surprised</source>
        <translation>놀란 얼굴</translation>
    </message>
    <message>
        <source>sad</source>
        <translation>슬픈 얼굴</translation>
    </message>
    <message>
        <source>angry</source>
        <translation>화난 얼굴</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>How did the face look?</source>
        <translation>어떤 표정이었나요?</translation>
    </message>
    <message>
        <source>Which was it?</source>
        <translation>어떤 도형이었나요?</translation>
    </message>
    <message>
        <source>The time is over. %1</source>
        <translation>시간이 다 되었습니다. %1</translation>
    </message>
    <message>
        <source>You are asked to take part in a study: %1. It has %3 trials. What is kept is the way of your finger, the force on it, times and answers, on this computer only, under the number %2 and without your name. You may pause at any time with P and stop with Escape, without giving a reason; the force is then off at once. Nothing has been kept so far. If you agree, press Enter. If you do not, press Escape.</source>
        <translation>연구에 참여해 주시기를 부탁드립니다: %1. 시행은 모두 %3회입니다. 손가락이 움직인 길과 손가락에 가해진 힘, 시간, 답이 이름 없이 번호 %2로 이 컴퓨터에만 저장됩니다. 이유를 말하지 않아도 언제든지 P 키로 쉬거나 Escape 키로 그만둘 수 있으며, 그러면 힘이 바로 꺼집니다. 지금까지는 아무것도 저장되지 않았습니다. 동의하시면 엔터 키를, 동의하지 않으시면 Escape 키를 누르세요.</translation>
    </message>
    <message>
        <source>Participants: %1.</source>
        <translation>참가자: %1명.</translation>
    </message>
    <message>
        <source>Trials that count: %1.</source>
        <translation>인정된 시행: %1회.</translation>
    </message>
    <message>
        <source>Trials done again: %1.</source>
        <translation>다시 한 시행: %1회.</translation>
    </message>
    <message>
        <source>Mean tracking error: %1 millimetres.</source>
        <translation>평균 추적 오차: %1밀리미터.</translation>
    </message>
    <message>
        <source>Named rightly: %1 percent.</source>
        <translation>바르게 답한 비율: %1퍼센트.</translation>
    </message>
    <message>
        <source>Mean time: %1 seconds.</source>
        <translation>평균 시간: %1초.</translation>
    </message>
    <message>
        <source>Feel the line; nothing is asked.</source>
        <translation>선을 만져 보세요. 질문은 없습니다.</translation>
    </message>
    <message>
        <source>The pull is cut at %1 newtons; the study asks for %2.</source>
        <translation>당기는 힘은 %1뉴턴으로 제한됩니다. 이 연구에는 %2뉴턴이 필요합니다.</translation>
    </message>
    <message>
        <source>The force may be stronger than this program usually allows, up to %1 newtons.</source>
        <translation>힘이 이 프로그램의 보통 한도보다 셀 수 있으며, 최대 %1뉴턴입니다.</translation>
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
        <source>The name %1 is cut off after %n line(s) of braille.</source>
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
        <source>Continue</source>
        <translation>계속</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>일시 정지</translation>
    </message>
    <message>
        <source>Discard…</source>
        <translation>버리기…</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>보관하기</translation>
    </message>
    <message>
        <source>Yes, discard it</source>
        <translation>예, 버리기</translation>
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
        <source>Key: Control+Z</source>
        <translation>Ctrl+Z 키</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>다시 실행: %1</translation>
    </message>
    <message>
        <source>Key: Control+Shift+Z</source>
        <translation>Ctrl+Shift+Z 키</translation>
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
        <source>There are no photographs in your folders yet. Import some, or choose other folders on the settings page.</source>
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
        <source>%1 is no longer in this list. Now: %2</source>
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
        <source>There are no photographs of that any more.</source>
        <translation>그에 해당하는 사진이 더는 없습니다.</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <comment>list, place in it, summary</comment>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>These are all the photographs; there is no list above them.</source>
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
        <source>There is no letter to delete.</source>
        <translation>지울 글자가 없습니다.</translation>
    </message>
    <message>
        <source>The search field is empty.</source>
        <translation>검색란이 비어 있습니다.</translation>
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
        <source>%1: %2. Choose one with the arrow keys and Enter.</source>
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
        <source>Swipe or use the arrow keys to move on; double tap or press Enter to listen.</source>
        <translation>화면을 쓸거나 화살표 키를 눌러 이동하고, 두 번 탭하거나 엔터 키를 눌러 들으세요.</translation>
    </message>
    <message>
        <source>Swipe or use the arrow keys to move on.</source>
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
        <source>Left and right: previous and next photograph. Up and down: its details. Enter: play the recordings, or pause. Escape: stop. Plus and minus: faster and slower. Home and End: first and last photograph. S: search. P: people. Y: years. L: places. K: keywords. R: surprise me. A: all photographs. Backspace: back. E: feel the face. C: look after this photograph. W: where am I. H: these keys. A swipe does what its arrow key does, a double tap plays, a two-finger tap stops, a Z drawn with two fingers goes back, a three-finger tap says where you are.</source>
        <translation>왼쪽과 오른쪽 화살표 키: 이전 사진과 다음 사진. 위쪽과 아래쪽 화살표 키: 사진 정보. 엔터 키: 녹음 재생 또는 일시 정지. Escape 키: 멈춤. 더하기와 빼기: 빠르게와 느리게. Home과 End 키: 첫 사진과 마지막 사진. S: 검색. P: 사람. Y: 연도. L: 장소. K: 키워드. R: 아무 사진이나 듣기. A: 모든 사진. 백스페이스: 뒤로. E: 얼굴 만져 보기. C: 이 사진 관리. W: 현재 위치. H: 이 키 안내. 쓸어 넘기기는 같은 방향의 화살표 키와 같고, 두 번 탭하면 재생하고, 두 손가락으로 탭하면 멈추고, 두 손가락으로 Z를 그리면 뒤로 가고, 세 손가락으로 탭하면 현재 위치를 알려 줍니다.</translation>
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
    <name>tp::CaptureCamera</name>
    <message>
        <source>The camera has stopped.</source>
        <translation>카메라가 멈췄습니다.</translation>
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
        <translation>모두 알맞으면 사진이 자동으로 찍힙니다.</translation>
    </message>
    <message>
        <source>The photograph is taken when you press Space or touch the screen.</source>
        <translation>스페이스바를 누르거나 화면을 탭하면 사진이 찍힙니다.</translation>
    </message>
    <message>
        <source>The microphone is on. The sound from five seconds before a photograph to five seconds after it is kept with it.</source>
        <translation>마이크가 켜져 있습니다. 사진을 찍기 5초 전부터 5초 뒤까지의 소리를 함께 저장합니다.</translation>
    </message>
    <message>
        <source>The microphone is off. Photographs are kept without sound.</source>
        <translation>마이크가 꺼져 있습니다. 사진을 소리 없이 저장합니다.</translation>
    </message>
</context>
<context>
    <name>tp::CaptureMemo</name>
    <message>
        <source>The recorder is still busy. Try again in a moment.</source>
        <translation>녹음기가 아직 작업 중입니다. 잠시 후 다시 시도하세요.</translation>
    </message>
    <message>
        <source>%1 Saved.</source>
        <translation>%1 저장되었습니다.</translation>
    </message>
</context>
<context>
    <name>tp::CaptureSession</name>
    <message>
        <source>Press I to import photographs of another camera.</source>
        <translation>다른 카메라의 사진을 가져오려면 I 키를 누르세요.</translation>
    </message>
    <message>
        <source>Take a photograph. %1.</source>
        <translation>사진 찍기. %1.</translation>
    </message>
    <message>
        <source>Take a photograph. Point the camera at somebody, and listen where to move it. When all is well, the photograph is taken automatically; press S if you do not want that. Space takes it at once.</source>
        <translation>사진 찍기. 카메라를 사람에게 향하고 어디로 움직일지 들으세요. 모두 알맞으면 사진이 자동으로 찍힙니다. 원하지 않으면 S 키를 누르세요. 스페이스바를 누르면 바로 찍힙니다.</translation>
    </message>
    <message>
        <source>The camera is starting.</source>
        <translation>카메라를 켜는 중입니다.</translation>
    </message>
    <message>
        <source>There is only one camera.</source>
        <translation>카메라가 하나뿐입니다.</translation>
    </message>
    <message>
        <source>Front camera.</source>
        <translation>전면 카메라.</translation>
    </message>
    <message>
        <source>Back camera.</source>
        <translation>후면 카메라.</translation>
    </message>
    <message>
        <source>This camera has no light.</source>
        <translation>이 카메라에는 조명이 없습니다.</translation>
    </message>
    <message>
        <source>Light on.</source>
        <translation>조명 켜짐.</translation>
    </message>
    <message>
        <source>Light off.</source>
        <translation>조명 꺼짐.</translation>
    </message>
    <message>
        <source>Take a photograph first; then you can record a memo for it.</source>
        <translation>먼저 사진을 찍으세요. 그다음 메모를 녹음할 수 있습니다.</translation>
    </message>
    <message>
        <source>The microphone is on.</source>
        <translation>마이크가 켜져 있습니다.</translation>
    </message>
</context>
<context>
    <name>tp::CaptureShutter</name>
    <message>
        <source>There is nothing to look through.</source>
        <translation>차례로 볼 것이 없습니다.</translation>
    </message>
    <message>
        <source>Frame %1 of %2: %3.</source>
        <translation>장면 %2개 중 %1번째: %3.</translation>
    </message>
    <message>
        <source>This one is kept too.</source>
        <translation>이것도 저장했습니다.</translation>
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
    <name>tp::CaptureTouch</name>
    <message>
        <source>There is no motor here that could tick. The tone and words lead you.</source>
        <translation>여기에는 톡톡 칠 수 있는 모터가 없습니다. 소리와 말로 안내합니다.</translation>
    </message>
    <message>
        <source>Ticks again: %1.</source>
        <translation>다시 톡톡: %1.</translation>
    </message>
    <message>
        <source>%1 Until then the tone and words lead you.</source>
        <translation>%1 그때까지 소리와 말로 안내합니다.</translation>
    </message>
    <message>
        <source>No more ticks from %1: until it is there again the tone and words lead you.</source>
        <translation>%1 장치에서 톡톡이 멈췄습니다. 다시 연결될 때까지 소리와 말로 안내합니다.</translation>
    </message>
</context>
<context>
    <name>tp::CareFolders</name>
    <message>
        <source>No folder was chosen.</source>
        <translation>폴더를 고르지 않았습니다.</translation>
    </message>
</context>
<context>
    <name>tp::CareHistory</name>
    <message>
        <source>Undone: %1.</source>
        <translation>되돌렸습니다: %1.</translation>
    </message>
    <message>
        <source>Redone: %1.</source>
        <translation>다시 실행했습니다: %1.</translation>
    </message>
    <message>
        <source>Deleted: %1. Undo brings it back.</source>
        <translation>삭제했습니다: %1. 되돌리기로 되살릴 수 있습니다.</translation>
    </message>
</context>
<context>
    <name>tp::CareSession</name>
    <message>
        <source>Look after the album. It has no folder yet. Import photographs, and choose where to keep them.</source>
        <translation>앨범 관리. 아직 폴더가 없습니다. 사진을 가져오고, 사진을 둘 곳을 고르세요.</translation>
    </message>
    <message>
        <source>Look after the album. %1 is open: its faces, recordings and description.</source>
        <translation>앨범 관리. %1 사진이 열려 있습니다. 얼굴, 녹음, 설명을 다룰 수 있습니다.</translation>
    </message>
    <message>
        <source>Look after the album. %1 Choose one, or import more.</source>
        <translation>앨범 관리. %1 사진을 하나 고르거나 더 가져오세요.</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s).</source>
        <translation>
            <numerusform>사진 %n장.</numerusform>
        </translation>
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
        <source>No force device is plugged in. Plug one in; it is found automatically.</source>
        <translation>연결된 힘 장치가 없습니다. 장치를 꽂으면 자동으로 찾습니다.</translation>
    </message>
    <message>
        <source>No force device is chosen. Choose one above.</source>
        <translation>힘 장치를 고르지 않았습니다. 위에서 고르세요.</translation>
    </message>
    <message>
        <source>The strongest force, %1 newtons: to the right, then to the left. Escape ends it.</source>
        <translation>최대 힘, %1뉴턴입니다. 오른쪽으로, 그다음 왼쪽으로 당깁니다. Escape 키로 끝냅니다.</translation>
    </message>
    <message>
        <source>Calibration. The device lies on the screen; put a finger into it, so that it touches the screen. Escape ends it. %1</source>
        <translation>보정을 시작합니다. 장치를 화면 위에 놓고, 손가락을 장치에 넣어 화면에 닿게 하세요. Escape 키로 끝냅니다. %1</translation>
    </message>
    <message>
        <source>That was the strongest force.</source>
        <translation>최대 힘이었습니다.</translation>
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
        <source>The calibration misses your touches by %1 millimetres on average, and at most %2 are allowed. Make sure that the device does not slip on the screen, keep still at each corner, and calibrate again.</source>
        <translation>보정 결과가 누른 자리와 평균 %1밀리미터 어긋납니다. 최대 %2까지 허용됩니다. 장치가 화면에서 미끄러지지 않게 하고, 모서리마다 가만히 있으면서 다시 보정하세요.</translation>
    </message>
    <message>
        <source>The device and the screen do not move alike. Calibrate again with the finger in the device, and no other on the screen.</source>
        <translation>장치와 화면의 움직임이 서로 맞지 않습니다. 손가락을 장치에 넣고, 다른 손가락은 화면에서 떼고 다시 보정하세요.</translation>
    </message>
    <message>
        <source>Calibrated. It misses by %1 millimetres on average, and is saved for this device.</source>
        <translation>보정했습니다. 평균 %1밀리미터 어긋나며, 이 장치의 보정값으로 저장했습니다.</translation>
    </message>
    <message>
        <source>Calibration cancelled. Nothing was changed.</source>
        <translation>보정을 취소했습니다. 바뀐 것은 없습니다.</translation>
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
        <source>This device knows its own force; only force sticks need measuring.</source>
        <translation>이 장치는 자기 힘의 크기를 알고 있습니다. 힘 스틱만 측정하면 됩니다.</translation>
    </message>
    <message>
        <source>%1 Escape ends it.</source>
        <translation>%1 Escape 키로 끝냅니다.</translation>
    </message>
    <message>
        <source>That is too little to be read well. The stick pulls twice as strongly now: weigh again.</source>
        <translation>너무 적어 정확히 읽을 수 없습니다. 이제 스틱이 두 배로 세게 당깁니다. 다시 무게를 재세요.</translation>
    </message>
    <message>
        <source>The stick is measured: %1 newtons at most. That is saved for this stick.</source>
        <translation>스틱을 측정했습니다. 최대 %1뉴턴이며, 이 스틱의 값으로 저장했습니다.</translation>
    </message>
    <message>
        <source>Measurement cancelled. The force is off. Nothing was changed.</source>
        <translation>측정을 취소했습니다. 힘이 꺼졌습니다. 바뀐 것은 없습니다.</translation>
    </message>
</context>
<context>
    <name>tp::ExploreChoices</name>
    <message>
        <source>None</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>Beeps</source>
        <translation>삐 소리</translation>
    </message>
    <message>
        <source>Clock directions</source>
        <translation>시계 방향 안내</translation>
    </message>
    <message>
        <source>Beeps and clock directions</source>
        <translation>삐 소리와 시계 방향</translation>
    </message>
    <message>
        <source>Guide: %1.</source>
        <translation>길잡이: %1.</translation>
    </message>
    <message>
        <source>Ticks under the finger</source>
        <translation>손가락 아래 톡톡</translation>
    </message>
    <message>
        <source>Ticks and beeps</source>
        <translation>톡톡과 삐 소리</translation>
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
    <message>
        <source>Ticks are on.</source>
        <translation>톡톡이 켜졌습니다.</translation>
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
        <source>Explore. %1 Move a finger over the picture; W says where it is.</source>
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
    <message>
        <source>Stopped. Ticks are off. Press Enter to switch them on.</source>
        <translation>멈췄습니다. 톡톡이 꺼져 있습니다. 엔터 키를 누르면 켜집니다.</translation>
    </message>
</context>
<context>
    <name>tp::ExploreTouch</name>
    <message>
        <source>There is nothing here that ticks under a finger. Beeps and words guide.</source>
        <translation>손가락 아래에서 톡톡 칠 수 있는 장치가 없습니다. 삐 소리와 말로 안내합니다.</translation>
    </message>
    <message>
        <source>Ticks: %1.</source>
        <translation>톡톡: %1.</translation>
    </message>
    <message>
        <source>Ticks: %1. They are off. Press Enter to switch them on.</source>
        <translation>톡톡: %1. 꺼져 있습니다. 엔터 키를 누르면 켜집니다.</translation>
    </message>
    <message>
        <source>%1 Until then beeps and words guide.</source>
        <translation>%1 그때까지 삐 소리와 말로 안내합니다.</translation>
    </message>
    <message>
        <source>%1 is gone. Beeps and words guide until it is there again.</source>
        <translation>%1 장치가 없어졌습니다. 다시 연결될 때까지 삐 소리와 말로 안내합니다.</translation>
    </message>
    <message>
        <source>%1 is gone. Until it is there again, ticks come from: %2.</source>
        <translation>%1 장치가 없어졌습니다. 다시 연결될 때까지 톡톡은 %2에서 옵니다.</translation>
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
    <message>
        <source>Ticks are off. Press Enter to switch them on.</source>
        <translation>톡톡이 꺼져 있습니다. 엔터 키를 누르면 켜집니다.</translation>
    </message>
    <message>
        <source>Tour round the %1. Follow the ticks: they grow toward the line.</source>
        <translation>%1 둘레를 안내합니다. 톡톡을 따라가세요. 선에 가까울수록 세집니다.</translation>
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
        <source>Search stopped. Press O to open a photograph.</source>
        <translation>찾기를 멈췄습니다. O를 눌러 사진을 여세요.</translation>
    </message>
    <message>
        <source>Search stopped. %1 is open again. The force is off. Press Enter to switch it on.</source>
        <translation>찾기를 멈췄습니다. %1 사진이 다시 열렸습니다. 힘이 꺼져 있습니다. 엔터 키를 누르면 켜집니다.</translation>
    </message>
    <message>
        <source>Search stopped. %1 is open again.</source>
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
        <source>Skipped %n photograph(s) without a face.</source>
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
        <source>Still looking: %n photograph(s) without a face so far.</source>
        <translation>
            <numerusform>계속 찾는 중입니다. 지금까지 얼굴이 없는 사진 %n장.</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no face on any photograph in the album.</source>
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
        <source>There is nothing more to zoom in to here.</source>
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
        <source>Saved: %1 is read in the page&apos;s language.</source>
        <translation>저장했습니다: %1, 페이지와 같은 언어로 읽습니다.</translation>
    </message>
    <message>
        <source>Saved: %1. Language of the name: %2.</source>
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
    <message>
        <source>Perhaps %1</source>
        <translation>아마 %1</translation>
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
        <source>None</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>Beeps</source>
        <translation>삐 소리</translation>
    </message>
    <message>
        <source>Clock directions</source>
        <translation>시계 방향 안내</translation>
    </message>
    <message>
        <source>Beeps and clock directions</source>
        <translation>삐 소리와 시계 방향</translation>
    </message>
    <message>
        <source>the guide</source>
        <translation>길잡이</translation>
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
    <message>
        <source>Ticks under the finger</source>
        <translation>손가락 아래 톡톡</translation>
    </message>
    <message>
        <source>Ticks and beeps</source>
        <translation>톡톡과 삐 소리</translation>
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
        <source>selected</source>
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
        <source>no subfolders</source>
        <translation>하위 폴더 없음</translation>
    </message>
    <message numerus="yes">
        <source>%n subfolder(s)</source>
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
    <name>tp::GroupCare</name>
    <message>
        <source>Looking for people…</source>
        <translation>사람을 찾는 중…</translation>
    </message>
    <message>
        <source>People</source>
        <translation>사람</translation>
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
        <translation>저장했습니다: %1, %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n photograph(s)</source>
        <translation>
            <numerusform>사진 %n장</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 Who is the next? %2.</source>
        <translation>%1 다음은 누구인가요? %2.</translation>
    </message>
    <message>
        <source>%1 Nobody is left without a name.</source>
        <translation>%1 이제 모두 이름이 있습니다.</translation>
    </message>
    <message>
        <source>This face is somebody else&apos;s.</source>
        <translation>이 얼굴은 다른 사람의 얼굴입니다.</translation>
    </message>
    <message>
        <source>This face is not that of %1.</source>
        <translation>이 얼굴은 %1의 얼굴이 아닙니다.</translation>
    </message>
    <message>
        <source>Selected: %1.</source>
        <translation>선택됨: %1.</translation>
    </message>
</context>
<context>
    <name>tp::ImportCare</name>
    <message>
        <source>From %1 into %2.</source>
        <translation>출처: %1, 대상: %2.</translation>
    </message>
    <message>
        <source>Looking for photographs…</source>
        <translation>사진을 찾는 중…</translation>
    </message>
    <message>
        <source>An import is running. Wait until it ends, or stop it first.</source>
        <translation>이미 가져오는 중입니다. 끝날 때까지 기다리거나 먼저 중단하세요.</translation>
    </message>
    <message>
        <source>Only photographs and folders on this computer can be imported.</source>
        <translation>이 컴퓨터에 있는 사진과 폴더만 가져올 수 있습니다.</translation>
    </message>
    <message>
        <source>Choose the folder to keep the album in. The photographs are copied into it.</source>
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
        <source>The folder %1 now belongs to the album.</source>
        <translation>이제 앨범에 속하는 폴더: %1.</translation>
    </message>
    <message>
        <source>Stopping after this photograph.</source>
        <translation>이 사진까지만 가져오고 멈춥니다.</translation>
    </message>
    <message>
        <source>The import continues.</source>
        <translation>가져오기를 계속합니다.</translation>
    </message>
    <message>
        <source>The import is discarded. What was imported stays.</source>
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
        <source>The folder %1 cannot be created: %2</source>
        <translation>폴더 %1: 만들 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The recording cannot be started: %1</source>
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
        <source>There is nothing to save yet. Start the servo first.</source>
        <translation>아직 저장할 것이 없습니다. 먼저 서보를 켜세요.</translation>
    </message>
    <message numerus="yes">
        <source>%n row(s) are in %1; the parameters lie beside them.</source>
        <translation>
            <numerusform>%1: %n줄을 저장했습니다. 매개변수는 그 옆에 있습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>The table cannot be written: %1</source>
        <translation>표를 쓸 수 없습니다: %1</translation>
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
        <source>%1 is empty.</source>
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
        <source>The servo is running: %1. Escape stops it.</source>
        <translation>서보가 작동 중: %1. Escape 키로 멈춥니다.</translation>
    </message>
    <message>
        <source>Only a simulated device that is running can be made to hang.</source>
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
        <source>Force field of %1: colours and arrows from 0 to %2 newtons. The scale bar is 20 mm long.</source>
        <translation>힘의 장, %1: 색과 화살표는 0부터 %2뉴턴까지입니다. 축척 막대의 길이는 20 mm입니다.</translation>
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
        <source>The lab. A finger on a simulated device, a force field, and everything that can be adjusted. Space on the surface starts the servo, Escape stops it.</source>
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
        <source>Nothing is running.</source>
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
        <translation>초기화</translation>
    </message>
    <message>
        <source>Law, servo, device and faults are reset.</source>
        <translation>유도 법칙, 서보, 장치, 고장을 초기화했습니다.</translation>
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
        <source>the text size</source>
        <translation>글자 크기</translation>
    </message>
    <message>
        <source>Text size: %1 percent.</source>
        <translation>글자 크기 %1퍼센트.</translation>
    </message>
    <message>
        <source>animations</source>
        <translation>애니메이션</translation>
    </message>
    <message>
        <source>Animations on.</source>
        <translation>애니메이션이 켜졌습니다.</translation>
    </message>
    <message>
        <source>Animations off.</source>
        <translation>애니메이션이 꺼졌습니다.</translation>
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
        <source>No point is selected. Tab goes from point to point.</source>
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
        <source>Deleted. Selected: %1.</source>
        <translation>삭제했습니다. 선택: %1.</translation>
    </message>
    <message>
        <source>This point cannot be a corner.</source>
        <translation>이 점은 모서리가 될 수 없습니다.</translation>
    </message>
    <message>
        <source>a point of the %1 was converted</source>
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
        <source>The %1 is gone again, because the program did not find it.</source>
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
        <source>The %1 was removed. It will not be felt.</source>
        <translation>%1: 없앴습니다. 만져지지 않게 됩니다.</translation>
    </message>
    <message>
        <source>a face was added</source>
        <translation>얼굴 추가</translation>
    </message>
    <message>
        <source>A face of the usual shape was added. Move its features into place.</source>
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
        <source>All changes are discarded: the contours are as they were when opened.</source>
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
        <source>%1: missing. It can be added.</source>
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
        <source>%1, %n point(s), none selected.</source>
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
        <source>This page mends the contours of a photograph. There is no photograph yet.</source>
        <translation>이 페이지에서 사진의 윤곽선을 고칩니다. 아직 사진이 없습니다.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a photograph and what is wrong with it</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No face was found in %1. You can add one of the usual shape and move it into place.</source>
        <translation>%1: 얼굴을 찾지 못했습니다. 보통 모양의 얼굴을 추가하여 자리를 맞출 수 있습니다.</translation>
    </message>
    <message>
        <source>Contours of %1. Selected: %2. Tab goes from point to point, the arrow keys move it.</source>
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
        <source>No speech engine was found on this computer, so TouchPhoto cannot speak. It tells a screen reader instead.</source>
        <translation>이 컴퓨터에서 음성 엔진을 찾지 못해 TouchPhoto가 말할 수 없습니다. 대신 화면 낭독기에 알립니다.</translation>
    </message>
</context>
<context>
    <name>tp::OpenAlbum</name>
    <message numerus="yes">
        <source>%n more thing(s) in the album need checking.</source>
        <translation>
            <numerusform>앨범에서 확인이 필요한 것이 %n개 더 있습니다.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>tp::PhotoRows</name>
    <message>
        <source>Not checked yet.</source>
        <translation>아직 확인하지 않았습니다.</translation>
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
        <source>Your settings could not be read. The default settings are used until that is put right.</source>
        <translation>설정을 읽을 수 없습니다. 해결될 때까지 기본 설정을 씁니다.</translation>
    </message>
    <message>
        <source>Your settings could not be read and were set aside. The default settings are used; you can choose again on the settings page.</source>
        <translation>설정을 읽을 수 없어 따로 옮겨 두었습니다. 기본 설정을 쓰며, 설정 페이지에서 다시 고를 수 있습니다.</translation>
    </message>
    <message>
        <source>Your settings could not be saved: %1</source>
        <translation>설정을 저장할 수 없습니다: %1</translation>
    </message>
</context>
<context>
    <name>tp::PrintSession</name>
    <message>
        <source>Print. Choose a photograph on the page &quot;Look after the album&quot;.</source>
        <translation>인쇄. ‘앨범 관리’ 페이지에서 사진을 고르세요.</translation>
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
        <source>The folder %1 could not be created: %2</source>
        <translation>폴더 %1: 만들 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The sheet is saved as %1. Print it at 100 percent, unscaled.</source>
        <translation>인쇄물을 저장했습니다: %1. 크기를 바꾸지 말고 100퍼센트로 인쇄하세요.</translation>
    </message>
    <message>
        <source>The sheet cannot be saved: %1</source>
        <translation>시트를 저장할 수 없습니다: %1</translation>
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
        <source>With the name in print.</source>
        <translation>이름을 글자로도 넣습니다.</translation>
    </message>
    <message>
        <source>Without the name in print.</source>
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
    <message>
        <source>Take a photograph</source>
        <translation>사진 찍기</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>연구</translation>
    </message>
    <message>
        <source>Still saving. TouchPhoto closes when everything is saved.</source>
        <translation>아직 저장하고 있습니다. 모두 저장되면 TouchPhoto가 닫힙니다.</translation>
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
        <source>Continue without a device</source>
        <translation>장치 없이 계속하기</translation>
    </message>
    <message>
        <source>Use this device</source>
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
        <source>The microphone picks up nothing. It may be switched off or covered.</source>
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
        <source>What was recorded is kept as &quot;%1&quot; and will be saved later, because %2</source>
        <translation>녹음한 것은 다음 파일에 남겨 두었고 나중에 저장합니다: “%1”. %2</translation>
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
        <source>Not given</source>
        <translation>지정 안 함</translation>
    </message>
    <message>
        <source>%1, %2, %3 of %4</source>
        <translation>%1, %2, %4개 중 %3번째</translation>
    </message>
    <message>
        <source>This is the first one.</source>
        <translation>첫 번째 녹음입니다.</translation>
    </message>
    <message>
        <source>This is the last one.</source>
        <translation>마지막 녹음입니다.</translation>
    </message>
    <message>
        <source>%1 is now number %2 of %3.</source>
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
    <name>tp::RecordingWait</name>
    <message>
        <source>A recording is being made. Finish it first.</source>
        <translation>녹음하는 중입니다. 먼저 녹음을 끝내세요.</translation>
    </message>
</context>
<context>
    <name>tp::SettingSteps</name>
    <message>
        <source>the reset</source>
        <translation>초기화</translation>
    </message>
    <message>
        <source>All settings are reset. The album&apos;s folders stay.</source>
        <translation>모든 설정을 초기화했습니다. 앨범의 폴더는 그대로입니다.</translation>
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
        <source>Settings. Go through them with Tab; every change is saved at once. Control+Z undoes the last one.</source>
        <translation>설정. 탭 키로 설정 사이를 이동하세요. 변경은 바로 저장됩니다. Ctrl+Z는 마지막 변경을 되돌립니다.</translation>
    </message>
</context>
<context>
    <name>tp::Shell</name>
    <message>
        <source>On every page: Escape stops whatever sounds or moves, then leads home. F1: this help. F2: repeat the last sentence. F3: voice on or off. Alt+Left: previous page.</source>
        <translation>어느 페이지에서나: Escape 키는 소리나 움직임을 멈추고, 그다음에는 홈으로 갑니다. F1: 이 도움말. F2: 마지막 문장 다시 듣기. F3: 음성 켜기 또는 끄기. Alt+왼쪽 화살표 키: 이전 페이지.</translation>
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
        <source>Same as the system</source>
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
        <source>Recordings play at %1 times normal speed.</source>
        <translation>녹음을 %1배 속도로 재생합니다.</translation>
    </message>
    <message>
        <source>sound effects</source>
        <translation>효과음</translation>
    </message>
    <message>
        <source>Sound effects on.</source>
        <translation>효과음이 켜졌습니다.</translation>
    </message>
    <message>
        <source>Sound effects off.</source>
        <translation>효과음이 꺼졌습니다.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>Short</source>
        <translation>짧게</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>자세히</translation>
    </message>
    <message>
        <source>People</source>
        <translation>사람</translation>
    </message>
    <message>
        <source>Time and place</source>
        <translation>시간과 장소</translation>
    </message>
    <message>
        <source>Only what people wrote about a photograph is said.</source>
        <translation>사람이 적은 내용만 말합니다.</translation>
    </message>
    <message>
        <source>What a photograph shows is said briefly.</source>
        <translation>사진에 보이는 것을 짧게 말합니다.</translation>
    </message>
    <message>
        <source>What a photograph shows is said in full.</source>
        <translation>사진에 보이는 것을 자세히 말합니다.</translation>
    </message>
    <message>
        <source>descriptions</source>
        <translation>사진 설명</translation>
    </message>
    <message>
        <source>what is said first</source>
        <translation>먼저 말할 것</translation>
    </message>
    <message>
        <source>People come first.</source>
        <translation>사람을 먼저 말합니다.</translation>
    </message>
    <message>
        <source>Time and place come first.</source>
        <translation>시간과 장소를 먼저 말합니다.</translation>
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
        <source>Speech, colours, force, where your photographs are</source>
        <translation>말, 색, 힘, 사진이 있는 곳</translation>
    </message>
    <message>
        <source>Take a photograph</source>
        <translation>사진 찍기</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>연구</translation>
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
    <message numerus="yes">
        <source>%n new photograph(s)</source>
        <translation>
            <numerusform>새 사진 %n장</numerusform>
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
            <numerusform>사람이 있는 사진 %n장</numerusform>
        </translation>
    </message>
    <message>
        <source>TouchPhoto, start page. %3 1: %1. 2: %2. More below; F1 for help.</source>
        <translation>TouchPhoto, 시작 페이지. %3 1: %1. 2: %2. 아래에 더 있습니다. 도움말은 F1 키입니다.</translation>
    </message>
    <message>
        <source>The camera is led to a face by words and a tone</source>
        <translation>말과 소리가 카메라를 얼굴로 안내합니다</translation>
    </message>
    <message>
        <source>For researchers: the published experiments, with people</source>
        <translation>연구자용: 논문의 실험을 사람과 함께 진행하기</translation>
    </message>
</context>
<context>
    <name>tp::StorageSettings</name>
    <message>
        <source>No folder was chosen.</source>
        <translation>폴더를 고르지 않았습니다.</translation>
    </message>
    <message>
        <source>This folder is already in the album.</source>
        <translation>이미 앨범에 있는 폴더입니다.</translation>
    </message>
    <message>
        <source>the added folder</source>
        <translation>추가한 폴더</translation>
    </message>
    <message>
        <source>%1 now belongs to the album.</source>
        <translation>이제 앨범에 속합니다: %1.</translation>
    </message>
    <message>
        <source>the removed folder</source>
        <translation>뺀 폴더</translation>
    </message>
    <message>
        <source>%1 no longer belongs to the album. Its photographs and recordings stay where they are.</source>
        <translation>이제 앨범에 속하지 않습니다: %1. 그 사진과 녹음은 그 자리에 그대로 남습니다.</translation>
    </message>
    <message>
        <source>Nothing leaves this computer: TouchPhoto connects to no other.</source>
        <translation>아무것도 이 컴퓨터를 떠나지 않습니다. TouchPhoto는 다른 컴퓨터에 연결하지 않습니다.</translation>
    </message>
    <message>
        <source>These settings, in %1.</source>
        <translation>이 설정이 저장된 곳: %1.</translation>
    </message>
    <message>
        <source>An index of the album, in %1 (%2). It can be deleted at any time.</source>
        <translation>앨범 색인이 저장된 곳: %1 (%2). 언제든지 지워도 됩니다.</translation>
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
        <source>The photograph you opened last: %1.</source>
        <translation>마지막으로 연 사진: %1.</translation>
    </message>
    <message>
        <source>The index is deleted when TouchPhoto ends, and rebuilt from the photographs at the next start.</source>
        <translation>색인은 TouchPhoto를 끝낼 때 지워지고, 다음에 시작할 때 사진에서 다시 만들어집니다.</translation>
    </message>
    <message>
        <source>In that index, for each face of the album, numbers by which it is known again.</source>
        <translation>그 색인에는 앨범의 얼굴마다 다시 알아보는 데 쓰는 숫자가 있습니다.</translation>
    </message>
    <message>
        <source>comparing faces</source>
        <translation>얼굴 비교</translation>
    </message>
    <message>
        <source>Faces are compared, so that names can be offered.</source>
        <translation>이름을 제안할 수 있도록 얼굴을 비교합니다.</translation>
    </message>
    <message>
        <source>Faces are not compared. What was kept about them is deleted; names stay.</source>
        <translation>얼굴을 비교하지 않습니다. 저장해 둔 얼굴 정보는 삭제되고 이름은 남습니다.</translation>
    </message>
</context>
<context>
    <name>tp::StudyFinger</name>
    <message>
        <source>The force device is not there. Connect it.</source>
        <translation>힘 장치가 없습니다. 장치를 연결하세요.</translation>
    </message>
    <message>
        <source>The device does not reach all of the experiment&apos;s surface, %1 by %2 millimetres: %3. Write a smaller surface into the experiment&apos;s file, or use the mouse.</source>
        <translation>장치가 실험 영역 전체(%1 x %2밀리미터)에 닿지 않습니다: %3. 실험 파일에 더 작은 영역을 적거나 마우스를 쓰세요.</translation>
    </message>
</context>
<context>
    <name>tp::StudyKeeping</name>
    <message>
        <source>In this folder lies a study of another experiment, or of another version of it. Choose another folder.</source>
        <translation>이 폴더에는 다른 실험이나 다른 판의 연구가 있습니다. 다른 폴더를 선택하세요.</translation>
    </message>
    <message>
        <source>In this folder lies a study with simulated participants. Choose another folder.</source>
        <translation>이 폴더에는 모의 참가자의 연구가 있습니다. 다른 폴더를 선택하세요.</translation>
    </message>
    <message>
        <source>The study&apos;s folder cannot be read, because the computer reports: %1</source>
        <translation>컴퓨터가 다음과 같이 알려서 연구 폴더를 읽을 수 없습니다: %1</translation>
    </message>
    <message>
        <source>The study&apos;s folder cannot be opened, because the computer reports: %1</source>
        <translation>컴퓨터가 다음과 같이 알려서 연구 폴더를 열 수 없습니다: %1</translation>
    </message>
    <message>
        <source>The study&apos;s folder is not open.</source>
        <translation>연구 폴더가 열려 있지 않습니다.</translation>
    </message>
    <message>
        <source>The trial cannot be kept, because the computer reports: %1</source>
        <translation>컴퓨터가 다음과 같이 알려서 시행을 저장할 수 없습니다: %1</translation>
    </message>
</context>
<context>
    <name>tp::StudyOverview</name>
    <message>
        <source>The study is being checked.</source>
        <translation>연구를 확인하고 있습니다.</translation>
    </message>
    <message>
        <source>No study has begun in this folder.</source>
        <translation>이 폴더에서 시작된 연구가 없습니다.</translation>
    </message>
    <message>
        <source>Nothing is wrong in the folder.</source>
        <translation>폴더에 문제가 없습니다.</translation>
    </message>
    <message>
        <source>Faults in the folder: %1.</source>
        <translation>폴더의 문제: %1개.</translation>
    </message>
    <message>
        <source>The report is being made.</source>
        <translation>보고서를 만들고 있습니다.</translation>
    </message>
    <message>
        <source>No trial counts yet, so that there is nothing to report.</source>
        <translation>아직 인정된 시행이 없어 보고할 것이 없습니다.</translation>
    </message>
    <message>
        <source>The report is in %1. Open the file %2 there.</source>
        <translation>보고서 폴더: %1. 그 안의 %2 파일을 여세요.</translation>
    </message>
    <message>
        <source>The rest is on the page.</source>
        <translation>나머지는 화면에 있습니다.</translation>
    </message>
</context>
<context>
    <name>tp::StudyRun</name>
    <message>
        <source>%1 Press Space to try again.</source>
        <translation>%1 스페이스바를 누르면 다시 시도합니다.</translation>
    </message>
    <message>
        <source>Your hand moves the finger with the mouse, on the screen or with the arrow keys, from where each trial begins. A tone says where the line is: faster is nearer, high is up, and it comes from the side where the line is.</source>
        <translation>마우스나 화면, 화살표 키로 각 시행의 시작점에서부터 손가락을 움직입니다. 소리가 선의 위치를 알려 줍니다. 빠를수록 가깝고, 높으면 위쪽이며, 선이 있는 쪽에서 들립니다.</translation>
    </message>
    <message>
        <source>That was the last trial. %1 Thank you. Press Space to end.</source>
        <translation>마지막 시행이었습니다. %1 감사합니다. 스페이스바를 누르면 끝납니다.</translation>
    </message>
    <message>
        <source>Time for a break. %1 Press Space to go on.</source>
        <translation>쉬는 시간입니다. %1 스페이스바를 누르면 계속합니다.</translation>
    </message>
    <message>
        <source>The device brings your finger to the start. Let it lead you.</source>
        <translation>장치가 손가락을 시작점으로 데려갑니다. 이끄는 대로 따라가세요.</translation>
    </message>
    <message>
        <source>The device brings your finger to the start again.</source>
        <translation>장치가 손가락을 다시 시작점으로 데려갑니다.</translation>
    </message>
    <message>
        <source>This trial has gone on for half an hour. Paused; it is done again. Press Space to go on.</source>
        <translation>시행이 30분째 이어지고 있습니다. 일시 정지했으며 처음부터 다시 합니다. 스페이스바를 누르면 계속합니다.</translation>
    </message>
    <message>
        <source>A part of the line was left out; the trial is done again.</source>
        <translation>선의 일부를 지나지 않았습니다. 이 시행은 다시 합니다.</translation>
    </message>
    <message>
        <source>The time is over; the trial is done again.</source>
        <translation>시간이 다 되었습니다. 이 시행은 다시 합니다.</translation>
    </message>
    <message>
        <source>%1 The trial could not be kept and does not count. Press Space to do it again.</source>
        <translation>%1 이 시행은 저장하지 못해 인정되지 않습니다. 스페이스바를 누르면 다시 합니다.</translation>
    </message>
    <message>
        <source>The end of the line was not reached; the trial is done again.</source>
        <translation>선의 끝에 이르지 않았습니다. 이 시행은 다시 합니다.</translation>
    </message>
    <message>
        <source>The study has ended for participant %1.</source>
        <translation>참가자 %1번의 연구가 끝났습니다.</translation>
    </message>
    <message>
        <source>Paused. The trial is done again. Press Space to go on.</source>
        <translation>일시 정지했습니다. 이 시행은 다시 합니다. 스페이스바를 누르면 계속합니다.</translation>
    </message>
    <message>
        <source>Paused. Press Space to go on.</source>
        <translation>일시 정지했습니다. 스페이스바를 누르면 계속합니다.</translation>
    </message>
    <message>
        <source>Nothing has been kept.</source>
        <translation>아무것도 저장되지 않았습니다.</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>그만두었습니다.</translation>
    </message>
    <message>
        <source>Stopped. Everything is kept. %1</source>
        <translation>그만두었습니다. 모두 저장되었습니다. %1</translation>
    </message>
    <message>
        <source>Stop the study? The force is off. Press Escape again to stop, or Space to go on.</source>
        <translation>연구를 그만둘까요? 힘은 꺼져 있습니다. Escape 키를 다시 누르면 그만두고, 스페이스바를 누르면 계속합니다.</translation>
    </message>
    <message>
        <source>%1 %2.</source>
        <translation>%1 %2.</translation>
    </message>
    <message>
        <source>Waiting for consent</source>
        <translation>동의를 기다리는 중</translation>
    </message>
    <message>
        <source>Getting ready</source>
        <translation>준비하는 중</translation>
    </message>
    <message>
        <source>The finger is brought to the start</source>
        <translation>손가락을 시작점으로 옮기는 중</translation>
    </message>
    <message>
        <source>Press Space to start</source>
        <translation>스페이스바를 누르면 시작</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>진행 중</translation>
    </message>
    <message>
        <source>Waiting for an answer</source>
        <translation>답을 기다리는 중</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>저장하는 중</translation>
    </message>
    <message>
        <source>Break. Press Space to go on</source>
        <translation>휴식. 스페이스바를 누르면 계속</translation>
    </message>
    <message>
        <source>Paused. Press Space to go on</source>
        <translation>일시 정지. 스페이스바를 누르면 계속</translation>
    </message>
    <message>
        <source>Stop? Escape stops, Space goes on</source>
        <translation>그만둘까요? Escape 키는 그만두기, 스페이스바는 계속</translation>
    </message>
    <message>
        <source>All trials are done. Press Space to end</source>
        <translation>모든 시행을 마쳤습니다. 스페이스바를 누르면 끝</translation>
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
        <translation>이 컴퓨터에 있는 파일만 열 수 있습니다.</translation>
    </message>
    <message>
        <source>%1 cannot be used as an experiment. %2</source>
        <translation>%1: 실험으로 쓸 수 없습니다. %2</translation>
    </message>
    <message>
        <source>The experiment has more than 9 answers, which have no keys.</source>
        <translation>실험의 답이 9개를 넘어 숫자 키로 답할 수 없습니다.</translation>
    </message>
    <message>
        <source>Participants have numbers from 1 to %1.</source>
        <translation>참가자 번호는 1에서 %1까지입니다.</translation>
    </message>
    <message>
        <source>Participant %1</source>
        <translation>참가자 %1번</translation>
    </message>
    <message>
        <source>Participant %1 is new.</source>
        <translation>참가자 %1번은 새 참가자입니다.</translation>
    </message>
    <message>
        <source>The program&apos;s experiments are not there. Open an experiment&apos;s file.</source>
        <translation>프로그램에 들어 있는 실험이 없습니다. 실험 파일을 여세요.</translation>
    </message>
    <message>
        <source>This experiment needs faces. Choose a folder with photographs named after person and expression, such as anna_smiling.jpg.</source>
        <translation>이 실험에는 얼굴이 필요합니다. anna_smiling.jpg처럼 사람과 표정으로 이름을 지은 사진이 있는 폴더를 선택하세요.</translation>
    </message>
    <message>
        <source>The faces are being read.</source>
        <translation>얼굴을 읽는 중입니다.</translation>
    </message>
    <message>
        <source>The study&apos;s folder is being read.</source>
        <translation>연구 폴더를 읽는 중입니다.</translation>
    </message>
    <message>
        <source>The study lies in %1.</source>
        <translation>연구 폴더: %1.</translation>
    </message>
    <message>
        <source>No folder is chosen.</source>
        <translation>선택한 폴더가 없습니다.</translation>
    </message>
    <message>
        <source>The faces are ready.</source>
        <translation>얼굴이 준비되었습니다.</translation>
    </message>
    <message>
        <source>Mouse, touch or keys, with a tone</source>
        <translation>마우스나 터치, 키와 소리</translation>
    </message>
    <message>
        <source>The scene is shown, to try it out. Nothing is kept.</source>
        <translation>시험 삼아 장면을 보여 줍니다. 아무것도 저장되지 않습니다.</translation>
    </message>
    <message>
        <source>The scene is not shown.</source>
        <translation>장면을 보여 주지 않습니다.</translation>
    </message>
    <message>
        <source>Studies. %1. Keys 1 to %2 choose the experiment, S starts it, F1 says more.</source>
        <translation>연구. %1. 1에서 %2까지의 키로 실험을 고르고, S 키로 시작합니다. F1 키를 누르면 도움말이 나옵니다.</translation>
    </message>
    <message>
        <source>The force may reach %1 newtons, as far as the device gives it, with your consent.</source>
        <translation>동의하셨으므로 장치가 낼 수 있는 한 힘이 %1뉴턴까지 될 수 있습니다.</translation>
    </message>
    <message>
        <source>This study asks for up to %1 newtons. The force is cut at %2 newtons, in %3 of %4 conditions, unless you consent to more. Key: L.</source>
        <translation>이 연구에는 최대 %1뉴턴이 필요합니다. 더 센 힘에 동의하지 않으시면 힘은 %2뉴턴으로 제한되며, 조건 %4개 중 %3개가 그렇습니다. L 키.</translation>
    </message>
    <message>
        <source>This study asks for no more force than the settings allow.</source>
        <translation>이 연구에는 설정이 허용하는 것보다 센 힘이 필요하지 않습니다.</translation>
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
        <source>Saving…</source>
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
        <source>The recorder is still busy. Try again in a moment.</source>
        <translation>녹음기가 아직 작업 중입니다. 잠시 후 다시 시도하세요.</translation>
    </message>
    <message>
        <source>Paused.</source>
        <translation>일시 정지했습니다.</translation>
    </message>
    <message>
        <source>Discard what was recorded? It cannot be brought back.</source>
        <translation>녹음한 것을 버릴까요? 되살릴 수 없습니다.</translation>
    </message>
    <message>
        <source>Discarded. Nothing was changed.</source>
        <translation>버렸습니다. 바뀐 것은 없습니다.</translation>
    </message>
    <message>
        <source>Kept. The recording is paused.</source>
        <translation>버리지 않았습니다. 녹음은 일시 정지되어 있습니다.</translation>
    </message>
    <message>
        <source>%1 Saved.</source>
        <translation>%1 저장되었습니다.</translation>
    </message>
    <message>
        <source>The album is still being changed. Try again in a moment.</source>
        <translation>앨범을 아직 바꾸는 중입니다. 잠시 후에 다시 해 보세요.</translation>
    </message>
</context>
<context>
    <name>tp::TickSettings</name>
    <message>
        <source>what ticks</source>
        <translation>톡톡 치는 장치</translation>
    </message>
    <message>
        <source>Ticks: %1.</source>
        <translation>톡톡: %1.</translation>
    </message>
    <message>
        <source>the strength of ticks</source>
        <translation>톡톡 치는 세기</translation>
    </message>
    <message>
        <source>Strength of ticks: %1 percent.</source>
        <translation>톡톡 치는 세기: %1퍼센트.</translation>
    </message>
    <message>
        <source>the sharpness of ticks</source>
        <translation>톡톡 치는 날카로움</translation>
    </message>
    <message>
        <source>Sharpness of ticks: %1 percent.</source>
        <translation>톡톡 치는 날카로움: %1퍼센트.</translation>
    </message>
    <message>
        <source>how late ticks are felt</source>
        <translation>톡톡 치는 느낌이 늦는 정도</translation>
    </message>
    <message numerus="yes">
        <source>Ticks are felt %n millisecond(s) late.</source>
        <translation>
            <numerusform>톡톡 치는 느낌이 %n밀리초 늦습니다.</numerusform>
        </translation>
    </message>
    <message>
        <source>There is nothing here that ticks under a finger.</source>
        <translation>손가락 아래에서 톡톡 칠 수 있는 장치가 없습니다.</translation>
    </message>
    <message>
        <source>Now.</source>
        <translation>지금입니다.</translation>
    </message>
    <message>
        <source>Seven ticks come. Press Space as soon as you feel one. The time from a tick to the key, less what people usually take, is how late ticks are felt; it is only about right.</source>
        <translation>톡 치는 느낌이 일곱 번 옵니다. 느껴지는 즉시 스페이스바를 누르세요. 톡 친 때부터 키를 누를 때까지의 시간에서 사람이 보통 걸리는 시간을 뺀 것이 늦는 정도이며, 대략적인 값입니다.</translation>
    </message>
    <message>
        <source>What ticks is gone.</source>
        <translation>톡톡 치는 장치가 없어졌습니다.</translation>
    </message>
    <message>
        <source>Too few ticks were answered. Nothing was changed.</source>
        <translation>너무 적게 눌렀습니다. 아무것도 바뀌지 않았습니다.</translation>
    </message>
    <message>
        <source>Ended.</source>
        <translation>끝냈습니다.</translation>
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
        <source>All of it stays, so there is nothing to cut off. Move the start or the end first.</source>
        <translation>모두 남게 되어 있어 잘라낼 것이 없습니다. 먼저 시작이나 끝을 옮기세요.</translation>
    </message>
    <message>
        <source>Trimmed: %1 stay. Undo brings the rest back.</source>
        <translation>잘랐습니다. 남은 길이: %1. 되돌리기로 나머지를 되살릴 수 있습니다.</translation>
    </message>
</context>
</TS>
