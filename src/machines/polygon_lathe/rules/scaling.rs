//! The rules of the electronic gears of slides, work and tool.

use crate::machines::driven::scaling;
use crate::machines::polygon_lathe::resolved::PolygonLathe;
use crate::machines::verdict::Judgement;

pub(super) fn scaling_x(lathe: &PolygonLathe) -> Option<Judgement> {
    scaling::judge(lathe.control, &lathe.drives()[0])
}

pub(super) fn scaling_z(lathe: &PolygonLathe) -> Option<Judgement> {
    scaling::judge(lathe.control, &lathe.drives()[1])
}

pub(super) fn scaling_work(lathe: &PolygonLathe) -> Option<Judgement> {
    scaling::judge(lathe.control, &lathe.turning_drives()[0])
}

pub(super) fn scaling_tool(lathe: &PolygonLathe) -> Option<Judgement> {
    scaling::judge(lathe.control, &lathe.turning_drives()[1])
}
