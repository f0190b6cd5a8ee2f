// SPDX-License-Identifier: Apache-2.0
import QtQuick
import TouchPhoto.Controls
import TouchPhoto.Lab

// Four plots of the last ten seconds, each below the sentence that says what it shows.
Grid {
    id: plots

    required property LabSession session
    property real cellHeight: 190 * Theme.textScale

    spacing: Theme.gap

    Repeater {
        model: [LabMeasurements.Position, LabMeasurements.Force, LabMeasurements.Energy, LabMeasurements.Lateness]
        delegate: Item {
            id: cell
            required property int index
            required property int modelData
            width: (plots.width - (plots.columns - 1) * plots.spacing) / plots.columns
            height: plots.cellHeight

            TpStatus {
                id: words
                width: parent.width
                text: plots.session.plots.readings[cell.index]
                font.pixelSize: Theme.smallSize
                maximumLineCount: 3
                elide: Text.ElideRight
            }
            Rectangle {
                anchors { left: parent.left; right: parent.right; top: words.bottom; bottom: parent.bottom; topMargin: 4 }
                color: Theme.panel
                radius: 4
                PlotItem {
                    anchors { fill: parent; margins: 4 }
                    measurements: plots.session.plots
                    quantity: cell.modelData
                    lineColor: Theme.line
                    secondColor: Theme.finger
                    textColor: Theme.quiet
                    gridColor: Theme.raised
                    textSize: Math.min(20, 0.8 * Theme.smallSize)
                }
            }
        }
    }
}
